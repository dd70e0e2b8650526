// `sluice play RECORDING`: shows a recording at any speed, forwards and backwards.
#pragma once

#include <optional>

#include "apps/sluice/play/viewer.hpp"
#include "media/recording.hpp"

namespace sluice::app {

class RecordingPlayer {
 public:
  RecordingPlayer(media::Recording recording, double speed, Viewer& viewer);

  /// Plays until the window is closed.
  void run();

 private:
  void answer(const media::WindowEvent& event);
  void answer_character(char32_t typed);
  void scrub(double x);
  void change_speed(double factor);
  void go_on();
  void advance();
  void show();
  size_t last() const { return recording_.frames() - 1; }

  media::Recording recording_;
  Viewer& viewer_;
  draw::Painter painter_;
  Playhead head_;
  size_t frame_ = 0;      // that is shown
  media::Moment moment_;  // of it
  bool paused_ = false;
  Clock::time_point since_ = Clock::now();
};

}  // namespace sluice::app
