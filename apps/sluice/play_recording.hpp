// `sluice play RECORDING`: shows a recording at any speed, forwards and backwards.
#pragma once

#include <optional>

#include "apps/sluice/play_viewer.hpp"
#include "media/recording.hpp"

namespace sluice {

class RecordingPlayer {
 public:
  RecordingPlayer(Recording recording, double speed, Viewer& viewer);

  /// Until the window is closed.
  void run();

 private:
  void answer(const WindowEvent& event);
  void answer_character(char32_t typed);
  void scrub(double x);
  void go_to(double frame);
  void change_speed(double factor);
  void advance();
  void show();
  size_t last() const { return recording_.frames() - 1; }

  Recording recording_;
  Viewer& viewer_;
  gpu::Painter painter_;
  Moment moment_;  // the frame that is shown
  size_t frame_ = 0;
  double position_ = 0;  // in frames
  double speed_;         // simulated seconds per second, below 0 backwards
  bool paused_ = false;
  Viewer::Clock::time_point since_ = Viewer::Clock::now();
};

}  // namespace sluice
