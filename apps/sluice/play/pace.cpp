// Arithmetic of time; the clock itself is asked by others.
#include "apps/sluice/play/pace.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sluice::app {
namespace {

double seconds_between(Clock::time_point from, Clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

}  // namespace

double changed_speed(double speed, double factor) {
  return std::copysign(std::clamp(std::abs(speed) * factor, least_speed, most_speed), speed);
}

void Pace::begin(double time, Clock::time_point now) {
  time_ = time_measured_ = time;
  since_ = measured_ = now;
  factor_ = 0;
  kept_up_ = true;
}

double Pace::target(Clock::time_point now) const { return time_ + speed_ * seconds_between(since_, now); }

void Pace::reached(double time, bool in_time, Clock::time_point now) {
  if (!in_time) {
    kept_up_ = false;
    time_ = time;
    since_ = now;
  }
  const double seconds = seconds_between(measured_, now);
  if (seconds < 0.5 || time == time_measured_) return;
  factor_ = std::exchange(kept_up_, true) ? speed_ : (time - time_measured_) / seconds;
  time_measured_ = time;
  measured_ = now;
}

void Pace::set_speed(double speed, Clock::time_point now) {
  time_ = target(now);
  since_ = now;
  speed_ = speed;
}

void Playhead::go_to(double frame) { position_ = std::clamp(frame, 0.0, last_); }

bool Playhead::advance(double seconds) {
  go_to(position_ + seconds * speed_ * fps_);
  return at_end();
}

}  // namespace sluice::app
