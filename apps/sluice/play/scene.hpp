// `sluice play SCENE`: simulates and shows it, at the pace of the clock where the machine keeps up.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/sluice/machine.hpp"
#include "apps/sluice/play/choice.hpp"
#include "apps/sluice/play/pace.hpp"
#include "apps/sluice/play/viewer.hpp"
#include "core/output/summary.hpp"
#include "core/solver/simulator.hpp"

namespace sluice::app {

class ScenePlayer {
 public:
  /// Loads the scene. InputError when it can't be run at all.
  ScenePlayer(const PlayOptions& options, const std::string& scene, Viewer& viewer);
  ~ScenePlayer();
  ScenePlayer(const ScenePlayer&) = delete;
  ScenePlayer& operator=(const ScenePlayer&) = delete;

  /// Plays until the window is closed.
  void run();

 private:
  struct Show;
  std::string change(Choice choice);
  bool change_and_say(Choice choice, const std::string& what);
  void start_again();
  void set_up(Show& show);
  void answer(const media::WindowEvent& event);
  void answer_character(char32_t typed);
  void choose_method(PressureMethod method);
  void refine(double factor);
  void go_to_scene(int steps);
  void change_dt(double factor);
  void change_speed(double factor);
  void pause_or_go_on();
  void advance();
  bool step();
  void show();
  std::vector<std::string> text() const;

  PlayOptions options_;
  Viewer& viewer_;
  Machine machine_;
  Choice choice_;
  Pace pace_;
  std::unique_ptr<Show> show_;
  bool paused_ = false;
  bool stop_awaited_ = true, paused_by_stop_ = false;  ///< the stop is that of --steps or --time
  int single_steps_ = 0;                               ///< steps asked for and not yet made
};

}  // namespace sluice::app
