// Clock and keys -> position in the recording -> pictures.
#include "apps/sluice/play/recording.hpp"

#include <fmt/format.h>

#include <cmath>

#include "apps/sluice/overlay_text.hpp"
#include "core/text.hpp"

namespace sluice::app {
namespace {

const std::vector<std::string> help_of_recordings = {
    "space  pause, go on",     "right left  one frame on, back", "b  backwards, forwards",
    "up down  faster, slower", "home end  first, last frame",    "r  from the start",
    "drag the bar  go there",
};

}  // namespace

RecordingPlayer::RecordingPlayer(media::Recording recording, double speed, Viewer& viewer)
    : recording_(std::move(recording)),
      viewer_(viewer),
      painter_(viewer.context(), recording_.scene(), recording_.samples(), recording_.scene().image_size),
      head_(last(), recording_.scene().fps, speed),
      moment_(recording_.moment(0)) {
  viewer_.begin(recording_.scene().image_size, recording_.scene().colour, help_of_recordings);
}

void RecordingPlayer::change_speed(double factor) {
  head_.set_speed(changed_speed(head_.speed(), factor));
  viewer_.say(fmt::format("speed {:g}", head_.speed()));
}

void RecordingPlayer::scrub(double x) {
  const auto bar = painter_.renderer().panels().timeline;
  if (!bar) return;
  const double place = (x - static_cast<double>(bar->left)) / static_cast<double>(bar->right - bar->left);
  paused_ = true;
  head_.go_to(std::round(place * static_cast<double>(last())));
}

/// Plays from where it is, or, when that is the end, from the start.
void RecordingPlayer::go_on() {
  if (head_.at_end()) head_.rewind();
  paused_ = false;
}

void RecordingPlayer::answer(const media::WindowEvent& event) {
  if (event.kind == media::WindowEvent::character) return answer_character(event.typed);
  // The viewer passes on presses and drags of the bar only.
  if (event.kind == media::WindowEvent::press || event.kind == media::WindowEvent::drag)
    return scrub(event.at.x);
  if (event.kind != media::WindowEvent::key) return;
  if (event.pressed == media::Key::right || event.pressed == media::Key::left) {
    paused_ = true;
    head_.move(event.pressed == media::Key::right ? 1 : -1);
  }
  if (event.pressed == media::Key::home) head_.go_to(0);
  if (event.pressed == media::Key::end) head_.go_to(static_cast<double>(last()));
  if (event.pressed == media::Key::up) change_speed(speed_per_key);
  if (event.pressed == media::Key::down) change_speed(1 / speed_per_key);
}

void RecordingPlayer::answer_character(char32_t typed) {
  switch (typed) {
    case ' ':
      if (paused_) {
        go_on();
      } else {
        paused_ = true;
      }
      return viewer_.say(fmt::format("{} at frame {}", paused_ ? "paused" : "goes on", head_.frame() + 1));
    case 'b':
      head_.set_speed(-head_.speed());
      paused_ = false;
      return viewer_.say(head_.speed() > 0 ? "forwards" : "backwards");
    case 'r':
      if (head_.at_end()) paused_ = false;  // a pause that nobody asked for
      head_.go_to(0);
      return viewer_.say("from the start");
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
  const auto now = Clock::now();
  const double seconds = std::chrono::duration<double>(now - since_).count();
  since_ = now;
  if (!paused_ && head_.advance(seconds)) {
    paused_ = true;
    viewer_.say(head_.speed() > 0 ? "the end; space plays it again" : "the start; space plays it again");
  }
  if (head_.frame() == frame_) return;
  frame_ = head_.frame();
  moment_ = recording_.moment(frame_);
}

void RecordingPlayer::show() {
  const Scene& scene = recording_.scene();
  viewer_.set_title(fmt::format("{} – {}{} – recording – Sluice", scene.title, title_of(scene.method),
                                paused_ ? " (paused)" : ""));
  draw::Frame labels;
  labels.text =
      overlay_text(scene, recording_.samples(), moment_.report, viewer_.overlay(), moment_.seconds_per_step);
  if (viewer_.overlay() == OverlayChoice::all) {
    labels.text.push_back(
        fmt::format("compression {:.2g} %", 100 * moment_.report.diagnostics.mean_compression));
    labels.text.push_back(fmt::format("frame {} of {}, {}", frame_ + 1, recording_.frames(),
                                      paused_ ? "paused" : fmt::format("speed × {:g}", head_.speed())));
    labels.played = last() == 0 ? 1 : static_cast<double>(frame_) / static_cast<double>(last());
  }
  const auto name = fmt::format("{}_{:06}", scene.name, moment_.report.step);
  viewer_.show(painter_, std::move(labels), name, [&](draw::Frame frame) {
    painter_.paint(std::move(frame), moment_.report.dt, moment_.state);
  });
}

void RecordingPlayer::run() {
  show();
  since_ = Clock::now();
  while (!viewer_.over()) {
    for (const media::WindowEvent& event : viewer_.turn(paused_ && !viewer_.changed())) answer(event);
    const size_t before = frame_;
    advance();
    if (viewer_.changed() || frame_ != before) show();
  }
}

}  // namespace sluice::app
