// Clock and keys -> position in the recording -> pictures.
#include "apps/sluice/play_recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/sluice/overlay_text.hpp"
#include "core/text.hpp"

namespace sluice {
namespace {

constexpr double speed_per_key = 2, least_speed = 1.0 / 1024, most_speed = 1024;

const std::vector<std::string> help = {
    "space  pause, go on",
    "right left  one frame on, back",
    "b  backwards, forwards",
    "up down  faster, slower",
    "home end  first, last frame",
    "r  from the start",
    "drag the bar  go there",
    "c  colours: speed, density, pressure",
    "o  text: none, facts, all",
    "drag, wheel, 0  move, zoom, whole view",
    "s  screenshot",
    "h  this help",
    "q  quit",
};

}  // namespace

RecordingPlayer::RecordingPlayer(Recording recording, double speed, Viewer& viewer)
    : recording_(std::move(recording)),
      viewer_(viewer),
      painter_(viewer.context(), recording_.scene(), recording_.samples(), recording_.scene().image_size),
      moment_(recording_.moment(0)),
      speed_(speed) {
  viewer_.begin(recording_.scene().image_size, recording_.scene().colour, help);
}

/// Shows this frame next, and goes on from there.
void RecordingPlayer::go_to(double frame) {
  position_ = std::clamp(frame, 0.0, static_cast<double>(last()));
  since_ = Viewer::Clock::now();
}

void RecordingPlayer::change_speed(double factor) {
  speed_ = std::copysign(std::clamp(std::abs(speed_) * factor, least_speed, most_speed), speed_);
  viewer_.say(fmt::format("speed {:g}", speed_));
}

void RecordingPlayer::scrub(double x) {
  const gpu::Box bar = *painter_.renderer().panels().timeline;
  const double place = (x - static_cast<double>(bar.left)) / static_cast<double>(bar.right - bar.left);
  go_to(std::round(place * static_cast<double>(last())));
}

void RecordingPlayer::answer(const WindowEvent& event) {
  if (event.kind == WindowEvent::character) return answer_character(event.typed);
  // The viewer leaves presses anywhere and drags of the bar.
  const auto& bar = painter_.renderer().panels().timeline;
  const bool on_bar = bar && event.at.y >= static_cast<double>(bar->top);
  if (event.kind == WindowEvent::drag || (event.kind == WindowEvent::press && on_bar)) {
    paused_ = true;
    return scrub(event.at.x);
  }
  if (event.kind != WindowEvent::key) return;
  const auto single = [&](double frames) {
    paused_ = true;
    go_to(static_cast<double>(frame_) + frames);
  };
  switch (event.pressed) {
    case Key::right: return single(1);
    case Key::left: return single(-1);
    case Key::home: return go_to(0);
    case Key::end: return go_to(static_cast<double>(last()));
    case Key::up: return change_speed(speed_per_key);
    case Key::down: return change_speed(1 / speed_per_key);
    default: return;
  }
}

void RecordingPlayer::answer_character(char32_t typed) {
  switch (typed) {
    case ' ': {
      paused_ = !paused_;
      const bool at_end = frame_ == (speed_ > 0 ? last() : 0);
      if (!paused_) go_to(!at_end ? position_ : speed_ > 0 ? 0 : static_cast<double>(last()));
      return viewer_.say(fmt::format("{} at frame {}", paused_ ? "paused" : "goes on", frame_));
    }
    case 'b': speed_ = -speed_; return viewer_.say(speed_ > 0 ? "forwards" : "backwards");
    case 'r': go_to(0); return viewer_.say("from the start");
    case '1':
    case '2':
    case '3':
    case 'n':
    case 'p':
    case '[':
    case ']':
    case '+':
    case '-': return viewer_.say("this is a recording; `sluice play SCENE` simulates, with other choices");
    default: return;
  }
}

void RecordingPlayer::advance() {
  const auto now = Viewer::Clock::now();
  const double seconds = std::chrono::duration<double>(now - since_).count();
  since_ = now;
  if (!paused_) {
    const double end = static_cast<double>(last());
    position_ = std::clamp(position_ + seconds * speed_ * recording_.scene().fps, 0.0, end);
    if (position_ == (speed_ > 0 ? end : 0)) {
      paused_ = true;
      viewer_.say(speed_ > 0 ? "the end; space plays it again" : "the start");
    }
  }
  const auto frame = static_cast<size_t>(position_ + 1e-6);
  if (frame == frame_) return;
  frame_ = frame;
  moment_ = recording_.moment(frame);
}

void RecordingPlayer::show() {
  const Scene& scene = recording_.scene();
  viewer_.set_title(fmt::format("{} – {}{} – recording – Sluice", scene.title, title_of(scene.method),
                                paused_ ? " (paused)" : ""));
  Frame labels;
  labels.text =
      overlay_text(scene, recording_.samples(), moment_.report, viewer_.overlay(), moment_.seconds_per_step);
  if (viewer_.overlay() == OverlayChoice::all) {
    labels.text.push_back(
        fmt::format("compression {:.2g} %", 100 * moment_.report.diagnostics.mean_compression));
    labels.text.push_back(fmt::format("frame {} of {}, {}", frame_, last(),
                                      paused_ ? "paused" : fmt::format("speed × {:g}", speed_)));
    labels.played = last() == 0 ? 1 : static_cast<double>(frame_) / static_cast<double>(last());
  }
  const auto name = fmt::format("{}_{:06}", scene.name, moment_.report.step);
  viewer_.show(painter_, std::move(labels), name,
               [&](Frame frame) { painter_.paint(std::move(frame), moment_.report.dt, moment_.state); });
}

void RecordingPlayer::run() {
  show();
  since_ = Viewer::Clock::now();
  while (!viewer_.over()) {
    for (const WindowEvent& event : viewer_.turn(paused_ && !viewer_.changed())) answer(event);
    const size_t before = frame_;
    advance();
    if (viewer_.changed() || frame_ != before) show();
  }
}

}  // namespace sluice
