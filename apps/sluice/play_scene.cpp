// Keys -> choice -> scene; clock -> steps -> pictures.
#include "apps/sluice/play_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "apps/sluice/overlay_text.hpp"
#include "apps/sluice/warnings.hpp"
#include "core/error.hpp"
#include "core/memory.hpp"
#include "core/scene_file.hpp"
#include "core/text.hpp"

namespace sluice {
namespace {

constexpr double dt_per_key = 1.25, most_dt_factor = 1000;
constexpr double speed_per_key = 2, least_speed = 1.0 / 1024, most_speed = 1024;
constexpr double largest_viscous_number = 0.4;  // nu dt/h^2, a little below what an explicit viscosity bears

const std::vector<std::string> help = {
    "space  pause, go on",
    "right  one step",
    "r  restart",
    "1 2 3  SSPH, IISPH, WCSPH",
    "n p  next, previous scene",
    "[ ]  coarser, finer particles",
    "+ -  larger, smaller time step",
    "up down  faster, slower",
    "c  colours: speed, density, pressure",
    "o  text: none, facts, all",
    "drag, wheel, 0  move, zoom, whole view",
    "s  screenshot",
    "h  this help",
    "q  quit",
};

/// Lattices that are counted instead of measured keep their size.
void scale_counts(const nlohmann::ordered_json& settings, double refinement,
                  std::vector<std::string>& overrides) {
  for (const char* section : {"fluid", "boundary"}) {
    if (!settings.contains(section) || !settings[section].contains("rect")) continue;
    const auto& rects = settings[section]["rect"];
    for (size_t k = 0; k < rects.size(); ++k) {
      if (!rects[k].contains("count")) continue;
      const auto scaled = [&](size_t axis) {
        return std::max<int64_t>(1, std::llround(rects[k]["count"][axis].get<double>() / refinement));
      };
      overrides.push_back(fmt::format("{}.rect.{}.count=[{},{}]", section, k, scaled(0), scaled(1)));
    }
  }
}

std::string missing_table(PressureMethod method) {
  return fmt::format("this scene has no [pressure.{}]; add that table with {} to its file to use {}",
                     name_of(method), method == PressureMethod::ssph ? "a stiffness" : "a kappa",
                     title_of(method));
}

}  // namespace

Scene load_choice(const Choice& choice) {
  std::vector<std::string> overrides = choice.overrides;
  if (choice.method) overrides.push_back(fmt::format("pressure.method={}", name_of(*choice.method)));
  Scene scene = load_scene(choice.scene, overrides);
  if (choice.refinement == 1 && choice.dt_factor == 1) return scene;
  const double spacing = scene.spacing * choice.refinement;
  double dt = scene.dt * choice.refinement * choice.dt_factor;
  if (scene.viscosity_model == ViscosityModel::laplacian && choice.dt_factor <= 1)
    dt = std::min(dt, largest_viscous_number * spacing * spacing / scene.viscosity);
  overrides.push_back(fmt::format("particles.spacing={:.17g}", spacing));
  overrides.push_back(fmt::format("time.dt={:.17g}", dt));
  if (choice.refinement != 1) scale_counts(scene.settings, choice.refinement, overrides);
  return load_scene(choice.scene, overrides);
}

void Pace::begin(double time) {
  time_ = time_measured_ = time;
  since_ = measured_ = Clock::now();
  factor_ = 0;
}

double Pace::target() const {
  return time_ + speed_ * std::chrono::duration<double>(Clock::now() - since_).count();
}

void Pace::reached(double time, bool in_time) {
  const Clock::time_point now = Clock::now();
  if (!in_time) {
    kept_up_ = false;
    time_ = time;
    since_ = now;
  }
  const double seconds = std::chrono::duration<double>(now - measured_).count();
  if (seconds < 0.5 || time == time_measured_) return;
  factor_ = std::exchange(kept_up_, true) ? speed_ : (time - time_measured_) / seconds;
  time_measured_ = time;
  measured_ = now;
}

void Pace::set_speed(double speed) {
  time_ = target();
  kept_up_ = false;
  since_ = Clock::now();
  speed_ = std::clamp(speed, least_speed, most_speed);
}

/// A scene while it is simulated.
struct ScenePlayer::Show {
  Scene scene;
  Samples samples;
  std::optional<Simulator> simulator;
  std::optional<gpu::Painter> painter;
  RunStatistics statistics;
  StepReport report;
  double seconds_per_step = 0;  // mean of about half a second
  double seconds = 0;           // of the steps since that was worked out
  uint64_t steps = 0;
  std::string failure;

  explicit Show(Scene loaded) : scene(std::move(loaded)), samples(sample(scene)) {}

  void start(Backend& backend, const gpu::Context& context) {
    simulator.emplace(scene, samples, backend);
    if (!painter) painter.emplace(context, scene, samples, scene.image_size);
    statistics = {};
    report = {};
    report.dt = simulator->dt();
    seconds_per_step = seconds = 0;
    steps = 0;
    failure.clear();
  }

  void count(double step_seconds) {
    seconds += step_seconds;
    ++steps;
    if (seconds < 0.25 && seconds_per_step > 0) return;
    seconds_per_step = std::exchange(seconds, 0) / static_cast<double>(std::exchange(steps, 0));
  }
};

ScenePlayer::ScenePlayer(const PlayOptions& options, const std::string& scene, Viewer& viewer)
    : options_(options),
      viewer_(viewer),
      machine_(options.machine, 0, &viewer.context()),
      choice_{scene, options.overrides, std::nullopt},
      pace_(options.speed) {
  fmt::print(stderr, "backend: {}\n", machine_.choice());
  show_ = std::make_unique<Show>(load_choice(choice_));
  require_memory(show_->scene, options_.machine.precision, available_memory());
  restart();
  viewer_.begin(show_->scene.image_size, show_->scene.colour, help);
  for (const std::string& limit : beyond_limits(show_->scene)) viewer_.say(limit);
}

ScenePlayer::~ScenePlayer() = default;

/// Sets up another scene; where that is not possible, returns why and keeps this one.
std::string ScenePlayer::change(Choice choice) {
  try {
    auto next = std::make_unique<Show>(load_choice(choice));
    require_memory(next->scene, options_.machine.precision, available_memory());
    std::swap(show_, next);
    try {
      restart();
    } catch (const Error&) {
      std::swap(show_, next);
      restart();  // the backend has forgotten its state
      throw;
    }
  } catch (const Error& error) {
    return error.what();
  }
  choice_ = std::move(choice);
  return {};
}

/// The same, and says what came of it.
bool ScenePlayer::change_and_say(Choice choice, const std::string& what) {
  if (const std::string problem = change(std::move(choice)); !problem.empty()) {
    viewer_.say(problem);
    return false;
  }
  std::string message = fmt::format("{}, dt {:g}", what, show_->simulator->dt());
  for (const std::string& limit : beyond_limits(show_->scene)) message += "; " + limit;
  viewer_.say(message);
  return true;
}

void ScenePlayer::restart() {
  show_->start(machine_.backend(), viewer_.context());
  stop_reached_ = false;
  pace_.begin(0);
}

void ScenePlayer::choose_method(PressureMethod method) {
  const Scene& scene = show_->scene;
  if ((method == PressureMethod::ssph && !scene.ssph) || (method == PressureMethod::wcsph && !scene.wcsph))
    return viewer_.say(missing_table(method));
  Choice choice = choice_;
  choice.method = method;
  choice.dt_factor = 1;
  std::erase_if(choice.overrides, [](const std::string& text) { return text.starts_with("time.dt="); });
  change_and_say(std::move(choice), std::string(title_of(method)));
}

/// The first of a few spacings with which fluid and walls don't get into each other's way.
void ScenePlayer::refine(double factor) {
  std::string problem;
  for (const int power : {1, 2, 3}) {
    Choice choice = choice_;
    choice.refinement *= std::pow(factor, power);
    if (std::abs(choice.refinement - 1) < 1e-9) choice.refinement = 1;
    problem = change(choice);
    if (!problem.empty()) continue;
    viewer_.say(fmt::format("spacing {:g}, dt {:g}, {} particles", show_->scene.spacing,
                            show_->simulator->dt(), show_->samples.fluid.size()));
    return;
  }
  viewer_.say(problem);
}

void ScenePlayer::go_to_scene(int steps) {
  const std::vector<std::string> names = shipped_scenes();
  if (names.empty()) return viewer_.say("there are no shipped scenes");
  const auto here = std::ranges::find(names, show_->scene.name);
  const auto count = static_cast<std::ptrdiff_t>(names.size());
  // From a scene of one's own the next is the first and the previous the last.
  const std::ptrdiff_t at = here == names.end() ? (steps > 0 ? -1 : 0) : here - names.begin();
  const std::string& name = names[static_cast<size_t>((at + steps + count) % count)];
  if (change_and_say({name, {}, std::nullopt}, name))
    viewer_.begin(show_->scene.image_size, show_->scene.colour, help);
}

void ScenePlayer::change_dt(double factor) {
  const double total = choice_.dt_factor * factor;
  if (total < 1 / most_dt_factor || total > most_dt_factor)
    return viewer_.say(fmt::format("dt stays {:g}", show_->simulator->dt()));
  if (!show_->failure.empty()) {  // from the start, with the other step
    Choice choice = choice_;
    choice.dt_factor *= factor;
    paused_ = !change_and_say(std::move(choice), "from the start");
    return;
  }
  choice_.dt_factor *= factor;
  show_->simulator->change_dt(show_->simulator->dt() * factor);
  viewer_.say(fmt::format("dt {:g}", show_->simulator->dt()));
}

void ScenePlayer::change_speed(double factor) {
  pace_.set_speed(pace_.speed() * factor);
  viewer_.say(fmt::format("speed {:g}", pace_.speed()));
}

void ScenePlayer::pause_or_go_on() {
  if (!show_->failure.empty())
    return viewer_.say("the run is invalid; r starts again, - with a smaller step");
  paused_ = !paused_;
  pace_.begin(show_->simulator->time());
  viewer_.say(fmt::format("{} at step {}", paused_ ? "paused" : "goes on", show_->simulator->steps()));
}

void ScenePlayer::answer(const WindowEvent& event) {
  if (event.kind == WindowEvent::character) return answer_character(event.typed);
  if (event.kind != WindowEvent::key) return;
  if (event.pressed == Key::right) {
    paused_ = true;
    ++single_steps_;
  }
  if (event.pressed == Key::up) change_speed(speed_per_key);
  if (event.pressed == Key::down) change_speed(1 / speed_per_key);
}

void ScenePlayer::answer_character(char32_t typed) {
  switch (typed) {
    case ' ': return pause_or_go_on();
    case 'r': restart(); return viewer_.say("from the start");
    case '1': return choose_method(PressureMethod::ssph);
    case '2': return choose_method(PressureMethod::iisph);
    case '3': return choose_method(PressureMethod::wcsph);
    case 'n': return go_to_scene(+1);
    case 'p': return go_to_scene(-1);
    case '[': return refine(1.25);
    case ']': return refine(0.8);
    case '+':
    case '=': return change_dt(dt_per_key);
    case '-': return change_dt(1 / dt_per_key);
    default: return;
  }
}

/// One step; false when none may follow.
bool ScenePlayer::step() {
  Show& show = *show_;
  if (!show.failure.empty()) return false;
  const auto before = Viewer::Clock::now();
  show.report = show.simulator->step();
  const double seconds = std::chrono::duration<double>(Viewer::Clock::now() - before).count();
  show.statistics.add(show.report);
  show.count(seconds);
  if (const auto& failure = show.simulator->failure()) {
    show.failure = failure_text(show.scene, show.statistics, *failure);
    paused_ = true;
    fmt::print(stderr, "sluice: invalid run: {}\n", show.failure);  // and in the picture until it is mended
    return false;
  }
  const bool stops = (options_.steps && show.report.step == *options_.steps) ||
                     (options_.time && show.report.time >= *options_.time - 0.5 * show.report.dt);
  if (stops && !std::exchange(stop_reached_, true)) {
    paused_ = true;
    viewer_.say(
        fmt::format("paused at step {}, time {:g}, as asked for", show.report.step, show.report.time));
    return false;
  }
  return true;
}

/// As many steps as the clock asks for, as far as they are computed before the next picture is due.
void ScenePlayer::advance() {
  for (; single_steps_ > 0; --single_steps_) step();
  if (paused_) return;
  const Simulator& simulator = *show_->simulator;
  bool in_time = true;
  while (simulator.time() + simulator.dt() <= pace_.target()) {
    if (!step()) return;
    in_time = viewer_.time_left();
    if (!in_time) break;
  }
  pace_.reached(simulator.time(), in_time);
}

std::vector<std::string> ScenePlayer::text() const {
  const Show& show = *show_;
  auto lines = overlay_text(show.scene, show.samples, show.report, viewer_.overlay(), show.seconds_per_step);
  if (viewer_.overlay() != OverlayChoice::none && !show.failure.empty())
    lines.push_back(fmt::format("invalid run: {}", show.failure));
  if (viewer_.overlay() != OverlayChoice::all) return lines;
  lines.push_back(fmt::format("compression {:.2g} %", 100 * show.report.diagnostics.mean_compression));
  if (paused_) {
    lines.push_back("paused");
  } else {
    lines.push_back(fmt::format("real time × {:.3g}", pace_.factor()));
  }
  return lines;
}

void ScenePlayer::show() {
  Show& show = *show_;
  viewer_.set_title(fmt::format("{} – {}{} – Sluice", show.scene.title, title_of(show.scene.method),
                                paused_ ? " (paused)" : ""));
  Frame labels;
  labels.text = text();
  const auto name = fmt::format("{}_{:06}", show.scene.name, show.report.step);
  viewer_.show(*show.painter, std::move(labels), name, [&](Frame frame) {
    // The buffers hold what a failed step led to, which may not be finite; the snapshot is fit to be shown.
    if (machine_.gpu_backend() != nullptr && show.failure.empty()) {
      show.painter->paint(std::move(frame), show.report.dt, *machine_.gpu_backend());
    } else {
      show.painter->paint(std::move(frame), show.report.dt, show.simulator->snapshot());
    }
  });
}

void ScenePlayer::run() {
  if (options_.steps == 0u || options_.time == 0.0) paused_ = stop_reached_ = true;
  while (!viewer_.over()) {
    for (const WindowEvent& event : viewer_.turn(paused_ && !viewer_.changed())) answer(event);
    const uint64_t before = show_->simulator->steps();
    advance();
    if (viewer_.changed() || show_->simulator->steps() != before) show();
  }
}

}  // namespace sluice
