// Simulated time against the clock: when the next step of a scene, or the next frame of a recording, is due.
#pragma once

#include <chrono>
#include <cstddef>

namespace sluice::app {

using Clock = std::chrono::steady_clock;

/// Limits of the simulated seconds per second that can be asked for.
constexpr double least_speed = 0.001, most_speed = 1000;
constexpr double speed_per_key = 2;  ///< factor by which a key changes it
/// Product of `speed` and `factor`, kept within these limits; the sign stays.
double changed_speed(double speed, double factor);

/// Pace of a simulation that is watched: how far it should be by now.
class Pace {
 public:
  explicit Pace(double speed) : speed_(speed) {}

  /// Begins at this simulated time, now.
  void begin(double time, Clock::time_point now);
  /// Simulated time that should be reached now.
  double target(Clock::time_point now) const;
  /// Notes that `time` was reached. Time that was not kept up with is given up.
  void reached(double time, bool in_time, Clock::time_point now);
  /// Simulated seconds per second: the speed where it was kept, else what came of it in the last half second
  /// or so; 0 before it is known.
  double factor() const { return factor_; }

  double speed() const { return speed_; }
  void set_speed(double speed, Clock::time_point now);

 private:
  double speed_;
  double time_ = 0, time_measured_ = 0, factor_ = 0;
  bool kept_up_ = true;  // since the factor was worked out
  Clock::time_point since_{}, measured_{};
};

/// Place in a recording that is being played.
class Playhead {
 public:
  /// Playhead at frame 0 of the frames 0 to `last`, of which `fps` are a simulated second.
  Playhead(size_t last, double fps, double speed)
      : last_(static_cast<double>(last)), fps_(fps), speed_(speed) {}

  size_t frame() const { return static_cast<size_t>(position_ + 1e-6); }
  void go_to(double frame);
  /// Moves one or more frames on, or back.
  void move(double frames) { go_to(static_cast<double>(frame()) + frames); }
  /// Plays on for so many seconds of the clock; true when that led to the end, or backwards to the start.
  bool advance(double seconds);
  bool at_end() const { return position_ == end(); }
  /// Goes to where playing begins: the start, or backwards the end.
  void rewind() { go_to(last_ - end()); }

  double speed() const { return speed_; }  ///< below 0 backwards
  void set_speed(double speed) { speed_ = speed; }

 private:
  double end() const { return speed_ > 0 ? last_ : 0; }

  double last_, fps_, speed_;
  double position_ = 0;  // in frames
};

}  // namespace sluice::app
