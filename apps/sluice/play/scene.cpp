// Keys -> choice -> scene; clock -> steps -> pictures.
#include "apps/sluice/play/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "apps/sluice/overlay_text.hpp"
#include "apps/sluice/warnings.hpp"
#include "core/solver/memory.hpp"
#include "core/text.hpp"
#include "sluice/error.hpp"
#include "sluice/load.hpp"

namespace sluice::app {
namespace {

constexpr double dt_per_key = 1.25, most_dt_factor = 1000;

const std::vector<std::string> help_of_scenes = {
    "space  pause, go on",
    "right  one step",
    "r  restart",
    "1 2 3  SSPH, IISPH, WCSPH",
    "n p  next, previous scene",
    "[ ]  coarser, finer particles",
    "+ -  larger, smaller time step",
    "up down  faster, slower",
};

}  // namespace

/// A scene while it is simulated.
struct ScenePlayer::Show {
  Scene scene;
  Samples samples;
  std::optional<Simulator> simulator;
  std::optional<draw::Painter> painter;
  RunStatistics statistics;
  StepReport report;
  double seconds_per_step = 0;  // mean of about a quarter of a second
  double seconds = 0;           // of the steps since that was worked out
  uint64_t steps = 0;
  std::string failure;

  /// Refuses what the machine has no room for before it makes room.
  Show(const Choice& choice, const MachineOptions& machine) : scene(load_choice(choice)) {
    require_memory(scene, machine.precision, available_memory(), memory_factor(machine));
    samples = sample(scene);
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
      pace_(options.speed),
      show_(std::make_unique<Show>(choice_, options.machine)) {
  fmt::print(stderr, "backend: {}\n", machine_.choice());
  set_up(*show_);
  viewer_.begin(show_->scene.image_size, show_->scene.colour, help_of_scenes);
  for (const std::string& limit : beyond_limits(show_->scene, show_->samples)) viewer_.say(limit);
}

ScenePlayer::~ScenePlayer() = default;

/// Begins from the start, on the backend, which forgets what it had.
void ScenePlayer::set_up(Show& show) {
  show.simulator.emplace(show.scene, show.samples, machine_.backend());
  if (!show.painter) show.painter.emplace(viewer_.context(), show.scene, show.samples, show.scene.image_size);
  show.report.dt = show.simulator->dt();
  pace_.begin(0, Clock::now());
}

/// Sets up another scene; where that is not possible, returns why and keeps this one.
std::string ScenePlayer::change(Choice choice) {
  std::unique_ptr<Show> next;
  try {
    next = std::make_unique<Show>(choice, options_.machine);
    set_up(*next);
  } catch (const std::exception& error) {  // Error, or no memory
    const bool backend_was_used = next != nullptr;
    next.reset();
    if (!backend_was_used) return error.what();
    show_ = std::make_unique<Show>(choice_, options_.machine);
    set_up(*show_);
    return fmt::format("{}; this one starts again", error.what());
  }
  // A pause that the user did not ask for is over.
  if (!show_->failure.empty() || paused_by_stop_) paused_ = false;
  paused_by_stop_ = false;
  stop_awaited_ = true;
  show_ = std::move(next);
  choice_ = std::move(choice);
  return {};
}

/// Changes the choice as change() does, and says what came of it.
bool ScenePlayer::change_and_say(Choice choice, const std::string& what) {
  if (const std::string problem = change(std::move(choice)); !problem.empty()) {
    viewer_.say(problem);
    return false;
  }
  std::string message = fmt::format("{}, dt {:g}", what, show_->simulator->dt());
  for (const std::string& limit : beyond_limits(show_->scene, show_->samples)) message += "; " + limit;
  viewer_.say(message);
  return true;
}

void ScenePlayer::start_again() { change_and_say(choice_, "from the start"); }

void ScenePlayer::choose_method(PressureMethod method) {
  try {
    change_and_say(with_method(choice_, method, show_->scene), std::string(title_of(method)));
  } catch (const InputError& error) {
    viewer_.say(error.what());
  }
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
  viewer_.say(fmt::format("no {} particles: {}", factor > 1 ? "coarser" : "finer", problem));
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
    viewer_.begin(show_->scene.image_size, show_->scene.colour, help_of_scenes);
}

void ScenePlayer::change_dt(double factor) {
  if (show_->scene.adaptive)
    return viewer_.say(fmt::format("the scene chooses its steps, dt {:g} now", show_->simulator->dt()));
  const double total = choice_.dt_factor * factor;
  if (total < 1 / most_dt_factor || total > most_dt_factor)
    return viewer_.say(fmt::format("dt stays {:g}", show_->simulator->dt()));
  if (!show_->failure.empty()) {
    Choice choice = choice_;
    choice.dt_factor = total;
    change_and_say(std::move(choice), "from the start");
    return;
  }
  choice_.dt_factor = total;
  show_->simulator->change_dt(show_->simulator->dt() * factor);
  Scene changed = show_->scene;
  changed.dt = show_->simulator->dt();
  std::string message = fmt::format("dt {:g}", changed.dt);
  for (const std::string& limit : beyond_limits(changed, show_->samples)) message += "; " + limit;
  viewer_.say(message);
}

void ScenePlayer::change_speed(double factor) {
  pace_.set_speed(changed_speed(pace_.speed(), factor), Clock::now());
  viewer_.say(fmt::format("speed {:g}", pace_.speed()));
}

void ScenePlayer::pause_or_go_on() {
  if (!show_->failure.empty())
    return viewer_.say("the run is invalid; r starts again, - with a smaller step");
  paused_ = !paused_;
  paused_by_stop_ = false;
  pace_.begin(show_->simulator->time(), Clock::now());
  viewer_.say(fmt::format("{} at step {}", paused_ ? "paused" : "goes on", show_->simulator->steps()));
}

void ScenePlayer::answer(const media::WindowEvent& event) {
  if (event.kind == media::WindowEvent::character) return answer_character(event.typed);
  if (event.kind != media::WindowEvent::key) return;
  if (event.pressed == media::Key::right) {
    paused_ = true;
    ++single_steps_;
  }
  if (event.pressed == media::Key::up) change_speed(speed_per_key);
  if (event.pressed == media::Key::down) change_speed(1 / speed_per_key);
}

void ScenePlayer::answer_character(char32_t typed) {
  switch (typed) {
    case ' ': return pause_or_go_on();
    case 'r': return start_again();
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
  const auto before = Clock::now();
  show.report = show.simulator->step();
  const double seconds = std::chrono::duration<double>(Clock::now() - before).count();
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
  if (stops && std::exchange(stop_awaited_, false)) {
    paused_by_stop_ = true;
    paused_ = true;
    viewer_.say(
        fmt::format("paused at step {}, time {:g}, as asked for", show.report.step, show.report.time));
    return false;
  }
  return true;
}

/// Makes as many steps as the clock asks for, as far as they are computed before the next picture is due.
void ScenePlayer::advance() {
  for (; single_steps_ > 0; --single_steps_) step();
  if (paused_) return;
  const Simulator& simulator = *show_->simulator;
  bool in_time = true;
  while (simulator.time() + simulator.dt() <= pace_.target(Clock::now())) {
    if (!step()) return;
    in_time = viewer_.time_left();
    if (!in_time) break;
  }
  pace_.reached(simulator.time(), in_time, Clock::now());
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
  } else if (pace_.factor() > 0) {
    lines.push_back(fmt::format("real time × {:.3g}", pace_.factor()));
  }
  return lines;
}

void ScenePlayer::show() {
  Show& show = *show_;
  viewer_.set_title(fmt::format("{} – {}{} – Sluice", show.scene.title, title_of(show.scene.method),
                                paused_ ? " (paused)" : ""));
  draw::Frame labels;
  labels.text = text();
  const auto name = fmt::format("{}_{:06}", show.scene.name, show.report.step);
  viewer_.show(*show.painter, std::move(labels), name, [&](draw::Frame frame) {
    // The buffers hold what a failed step led to, which may not be finite; the snapshot is fit to be shown.
    if (machine_.gpu_backend() != nullptr && show.failure.empty()) {
      show.painter->paint(std::move(frame), show.report.dt, *machine_.gpu_backend());
    } else {
      show.painter->paint(std::move(frame), show.report.dt, show.simulator->snapshot());
    }
  });
}

void ScenePlayer::run() {
  if (options_.steps == 0u || options_.time == 0.0) paused_ = true;
  while (!viewer_.over()) {
    for (const media::WindowEvent& event : viewer_.turn(paused_ && !viewer_.changed())) answer(event);
    const uint64_t before = show_->simulator->steps();
    advance();
    if (viewer_.changed() || show_->simulator->steps() != before) show();
  }
}

}  // namespace sluice::app
