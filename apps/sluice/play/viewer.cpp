// The answers to what every part of `sluice play` understands.
#include "apps/sluice/play/viewer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/output/output_file.hpp"
#include "draw/image.hpp"
#include "sluice/error.hpp"

namespace sluice::app {
namespace {

using namespace std::chrono_literals;
constexpr auto between_pictures = 16'666'667ns;
constexpr auto while_idle = 250ms;
constexpr double zoom_per_click = 1.25, least_zoom = 0.1, most_zoom = 1000;

bool holds(const draw::Box& box, glm::dvec2 at) {
  const glm::vec2 place(at);
  return place.x >= box.left && place.x < box.right && place.y >= box.top && place.y < box.bottom;
}

/// What every part of `sluice play` answers.
constexpr std::array<const char*, 6> common_help{"c  colours: speed, density, pressure",
                                                 "o  text: none, facts, all",
                                                 "drag, wheel, 0  move, zoom, whole view",
                                                 "s  screenshot",
                                                 "h  this help",
                                                 "q  quit"};

/// A file that is not there yet.
std::filesystem::path free_name(const std::string& name) {
  std::filesystem::path path = name + ".png";
  std::error_code error;
  for (int k = 2; std::filesystem::exists(path, error); ++k) path = fmt::format("{}_{}.png", name, k);
  return path;
}

}  // namespace

Viewer::Viewer(glm::uvec2 size, OverlayChoice overlay, const std::optional<std::filesystem::path>& shader_dir)
    : window_(size, "Sluice"),
      context_([this] { window_.make_current(); }, gpu::ShaderLibrary(shader_dir)),
      overlay_(overlay) {}

void Viewer::begin(glm::uvec2 size, Colour colour, std::vector<std::string> help) {
  window_.resize(size);
  colour_ = colour;
  camera_ = {};
  help_ = std::move(help);
  help_.insert(help_.end(), common_help.begin(), common_help.end());
  shows_help_ = wants_screenshot_ = drags_bar_ = false;
  timeline_.reset();
  changed_ = true;
}

void Viewer::set_title(const std::string& title) { window_.set_title(title); }

void Viewer::say(const std::string& message) {
  message_ = message;
  changed_ = true;
  fmt::print(stderr, "sluice: {}\n", message);
}

std::vector<media::WindowEvent> Viewer::turn(bool idle) {
  const auto now = Clock::now();
  const auto wait = idle ? while_idle : std::max<Clock::duration>(next_ - now, 0ns);
  std::vector<media::WindowEvent> events = window_.events(std::chrono::duration<double>(wait).count());
  next_ = std::max(next_ + between_pictures, Clock::now());
  deadline_ = Clock::now() + between_pictures * 3 / 2;
  changed_ = changed_ || !events.empty();
  for (const media::WindowEvent& event : events) {
    if (event.kind == media::WindowEvent::key || event.kind == media::WindowEvent::character)
      message_.clear();
  }
  std::erase_if(events, [this](const media::WindowEvent& event) { return answers(event); });
  return events;
}

bool Viewer::answers(const media::WindowEvent& event) {
  switch (event.kind) {
    case media::WindowEvent::character: return answers_character(event.typed);
    case media::WindowEvent::key:
      if (event.pressed != media::Key::escape) return false;
      shows_help_ = false;
      return true;
    case media::WindowEvent::press:
      drags_bar_ = timeline_ && holds(*timeline_, event.at);
      return timeline_ && !drags_bar_;
    case media::WindowEvent::drag:
      if (!drags_bar_) camera_.shift += event.moved;
      return !drags_bar_;
    case media::WindowEvent::wheel: zoom(event.at, std::pow(zoom_per_click, event.clicks)); return true;
    case media::WindowEvent::release: drags_bar_ = false; return true;
    case media::WindowEvent::redraw: return true;
  }
  return false;
}

bool Viewer::answers_character(char32_t typed) {
  switch (typed) {
    case 'c': colour_ = static_cast<Colour>((static_cast<int>(colour_) + 1) % 3); return true;
    case 'o': overlay_ = static_cast<OverlayChoice>((static_cast<int>(overlay_) + 1) % 3); return true;
    case 'h':
    case '?': shows_help_ = !shows_help_; return true;
    case '0': camera_ = {}; return true;
    case 's': wants_screenshot_ = true; return true;
    case 'q': over_ = true; return true;
    default: return false;
  }
}

/// What is under `about` stays there.
void Viewer::zoom(glm::dvec2 about, double factor) {
  const double zoomed = std::clamp(camera_.zoom * factor, least_zoom, most_zoom);
  camera_.shift = about - zoomed / camera_.zoom * (about - camera_.shift);
  camera_.zoom = zoomed;
}

void Viewer::show(draw::Painter& painter, draw::Frame labels, const std::string& name,
                  const std::function<void(draw::Frame)>& paint) {
  labels.colour = colour_;
  // As in pictures of runs; with `all` speed has its bar too.
  labels.colour_bar =
      overlay_ == OverlayChoice::all || (overlay_ == OverlayChoice::facts && colour_ != Colour::speed);
  if (shows_help_) {
    labels.text = help_;
    labels.long_text = true;
    labels.colour_bar = false;
  } else if (overlay_ != OverlayChoice::none && !message_.empty()) {
    labels.text.push_back(message_);
  }
  painter.renderer().look(glm::max(window_.size(), draw::smallest_picture), camera_);
  paint(std::move(labels));
  timeline_ = painter.renderer().panels().timeline;
  drags_bar_ = drags_bar_ && timeline_;
  painter.renderer().show(glm::uvec2(0), window_.size().y);
  present();
  if (std::exchange(wants_screenshot_, false)) save_screenshot(painter.renderer(), name);
}

void Viewer::present() {
  window_.present();
  changed_ = false;
}

void Viewer::save_screenshot(const draw::Renderer& renderer, const std::string& name) {
  try {
    const std::filesystem::path path = free_name(name);
    write_file(path, draw::encode_png(renderer.read()));
    say(fmt::format("screenshot {}", path.string()));
  } catch (const EnvironmentError& error) {
    say(error.what());
  }
}

}  // namespace sluice::app
