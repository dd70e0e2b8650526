// `sluice play SCENE`: simulates and shows it, at the pace of the clock where the machine keeps up.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/sluice/machine.hpp"
#include "apps/sluice/play_viewer.hpp"
#include "core/simulator.hpp"
#include "core/summary.hpp"

namespace sluice {

/// What is chosen with keys. The scene as its file has it, changed by the command line, is where it starts.
struct Choice {
  std::string scene;
  std::vector<std::string> overrides;
  std::optional<PressureMethod> method;
  double refinement = 1;  ///< spacing over that of the file
  double dt_factor = 1;   ///< dt over that of the file, beyond what the spacing asks for
};

/// The scene of a choice. Time steps follow the spacing, as far as an explicit viscosity allows. InputError
/// as of load_scene.
Scene load_choice(const Choice& choice);

/// How far simulated time follows the clock.
class Pace {
 public:
  explicit Pace(double speed) : speed_(speed) {}

  void begin(double time);  ///< from this simulated time on, now
  /// The simulated time that should be reached now.
  double target() const;
  /// `time` was reached. Time that was not kept up with is given up.
  void reached(double time, bool in_time);
  /// Simulated seconds per second, over the last half second or so; 0 before.
  double factor() const { return factor_; }

  double speed() const { return speed_; }
  void set_speed(double speed);

 private:
  using Clock = std::chrono::steady_clock;
  double speed_;
  double time_ = 0, time_measured_ = 0, factor_ = 0;
  bool kept_up_ = true;  // since the factor was worked out
  Clock::time_point since_ = Clock::now(), measured_ = since_;
};

class ScenePlayer {
 public:
  /// InputError when the scene can't be run at all.
  ScenePlayer(const PlayOptions& options, const std::string& scene, Viewer& viewer);
  ~ScenePlayer();
  ScenePlayer(const ScenePlayer&) = delete;
  ScenePlayer& operator=(const ScenePlayer&) = delete;

  /// Until the window is closed.
  void run();

 private:
  struct Show;
  std::string change(Choice choice);
  bool change_and_say(Choice choice, const std::string& what);
  void restart();
  void answer(const WindowEvent& event);
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
  bool paused_ = false, stop_reached_ = false;
  int single_steps_ = 0;  ///< asked for and not yet made
};

}  // namespace sluice
