// The simulator with all that it refers to, and its fields by name.
#include "sluice/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "core/agree/agreement.hpp"
#include "core/measure/point.hpp"
#include "core/measure/probes.hpp"
#include "core/measure/wall_forces.hpp"
#include "core/output/checkpoint.hpp"
#include "core/output/state_file.hpp"
#include "core/output/summary.hpp"
#include "core/solver/limits.hpp"
#include "core/solver/memory.hpp"
#include "core/solver/simulator.hpp"

namespace sluice {
namespace {

/// What people call the fields of the state, and where the stages have it.
struct StateField {
  FieldDescription description;
  Field field;
};
constexpr std::array<StateField, 4> state_fields = {{
    {{"position", "length", "position after the last step"}, Field::x_in},
    {{"velocity", "length/time", "velocity after the last step"}, Field::v_in},
    {{"density", "density", "density, computed during the last step; of the start before the first"},
     Field::rho},
    {{"pressure", "density velocity^2", "pressure, computed during the last step; 0 before the first"},
     Field::p},
}};

template <class T>
std::vector<std::byte> copied(const std::vector<T>& values) {
  const auto bytes = std::as_bytes(std::span(values));
  return {bytes.begin(), bytes.end()};
}

std::string_view words_for(NumberType type) {
  switch (type) {
    case NumberType::float32: return "float";
    case NumberType::float64: return "double";
    case NumberType::uint32: break;
  }
  return "uint32_t";
}

size_t size_of(NumberType type) { return type == NumberType::float64 ? 8 : 4; }

template <class T>
constexpr NumberType number_type = std::is_same_v<T, float>    ? NumberType::float32
                                   : std::is_same_v<T, double> ? NumberType::float64
                                                               : NumberType::uint32;

/// Refuses the scene if it needs more memory than there is, and samples it otherwise.
Samples sampled(const Scene& scene, const Backend& backend) {
  require_memory(scene, backend.precision(), available_memory());
  return sample(scene);
}

Samples sampled(const Scene& scene, const Checkpoint& from, const Backend& backend, const std::string& file) {
  if (from.precision != backend.precision()) {
    throw InputError(fmt::format("{}: found a checkpoint in {}, expected one in {}, the device's precision",
                                 file, name_of(from.precision), name_of(backend.precision())));
  }
  Samples samples = sampled(scene, backend);
  require_particles(file, from.state, samples);
  return samples;
}

}  // namespace

Device::Device(std::unique_ptr<Backend> backend) : backend_(std::move(backend)) {}
Device::~Device() = default;
Device::Device(Device&&) noexcept = default;
Device& Device::operator=(Device&&) noexcept = default;

std::string Device::name() const { return backend_->name(); }
std::string Device::description() const { return backend_->device(); }
Precision Device::precision() const { return backend_->precision(); }
int Device::threads() const { return backend_->threads(); }

template <class T>
std::span<const T> FieldView::as() const {
  if (type != number_type<T>) {
    throw InputError(fmt::format("a field of {}: found a request for {}, expected its own type",
                                 words_for(type), words_for(number_type<T>)));
  }
  return {reinterpret_cast<const T*>(bytes.data()), bytes.size() / sizeof(T)};
}
template std::span<const float> FieldView::as() const;
template std::span<const double> FieldView::as() const;
template std::span<const uint32_t> FieldView::as() const;

struct Simulation::State {
  Scene scene;
  Device device;
  Samples samples;
  Simulator simulator;
  RunStatistics statistics;
  Stopwatch watch{};
  mutable std::map<std::string, std::vector<std::byte>> values{};  ///< of the views that were given out
  mutable std::optional<Snapshot> state{};                         ///< that points and lines are measured in
  mutable std::optional<WallForces> walls{};

  Backend& backend() const { return *device.backend_; }
  /// The field of the stages with this name. InputError, with `more` names before theirs, if there is none.
  Field planned(std::string_view name, std::string_view more) const;
  /// Numbers of a field of the state, by ids; after a failure those that can be shown.
  std::vector<double> values_of_state(Field field) const;
  const Snapshot& now() const { return state ? *state : state.emplace(simulator.snapshot()); }
  void forget() {
    values.clear();
    state.reset();
  }
  FieldView keep(std::string_view name, std::vector<std::byte> bytes, NumberType type, size_t columns) const;

  State(Scene its_scene, Device its_device)
      : scene(std::move(its_scene)),
        device(std::move(its_device)),
        samples(sampled(scene, backend())),
        simulator(scene, samples, backend()) {}

  State(Checkpoint from, Device its_device, const std::string& file)
      : scene(std::move(from.scene)),
        device(std::move(its_device)),
        samples(sampled(scene, from, backend(), file)),
        simulator(scene, samples, backend(), from.state),
        statistics(from.counts) {}
};

Simulation::Simulation(Scene scene, Device device)
    : state_(std::make_unique<State>(std::move(scene), std::move(device))) {}
Simulation::Simulation(std::unique_ptr<State> state) : state_(std::move(state)) {}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

Simulation Simulation::resume(const std::filesystem::path& checkpoint, Device device) {
  return Simulation(
      std::make_unique<State>(read_checkpoint(checkpoint), std::move(device), checkpoint.string()));
}

StepReport Simulation::step(double end) {
  Simulator& simulator = state_->simulator;
  if (const auto& failure = simulator.failure())
    throw InputError(fmt::format("{}: the run became invalid in step {}: {}", state_->scene.file,
                                 failure->step, failure->reason));
  if (!(end > simulator.time())) {
    throw InputError(
        fmt::format("{}: found {:g} as the end of a step, expected a time after {:g}, where it begins",
                    state_->scene.file, end, simulator.time()));
  }
  state_->forget();
  state_->watch.start();
  StepReport report = simulator.step(end);
  state_->watch.stop();
  state_->statistics.add(report);
  return report;
}

void Simulation::run(double time, const std::function<bool(const StepReport&)>& after_step) {
  const auto goes_on = [&](const StepReport& report) {
    return !failure() && (!after_step || after_step(report));
  };
  if (state_->scene.adaptive) {
    while (this->time() < time && goes_on(step(time))) {
    }
    return;
  }
  // As many steps as `sluice run` makes: what rounding leaves does not count.
  const double steps = std::round((time - this->time()) / dt());
  for (double k = 0; k < steps && goes_on(step()); ++k) {
  }
}

const Scene& Simulation::scene() const& { return state_->scene; }
Scene Simulation::scene() && { return std::move(state_->scene); }
const Samples& Simulation::samples() const& { return state_->samples; }
Samples Simulation::samples() && { return std::move(state_->samples); }
const Device& Simulation::device() const { return state_->device; }
size_t Simulation::particles() const { return state_->samples.fluid.size(); }
uint64_t Simulation::steps() const { return state_->simulator.steps(); }
double Simulation::time() const { return state_->simulator.time(); }
double Simulation::dt() const { return state_->simulator.dt(); }
std::optional<Failure> Simulation::failure() const { return state_->simulator.failure(); }
std::vector<std::string> Simulation::warnings() const {
  return beyond_limits(state_->scene, state_->samples);
}
Snapshot Simulation::snapshot() const { return state_->simulator.snapshot(); }

std::vector<FieldDescription> Simulation::fields() const {
  std::vector<FieldDescription> all;
  for (const StateField& each : state_fields) all.push_back(each.description);
  const FieldSet planned = state_->simulator.plan().fields();
  for (uint32_t f = 0; f < field_count; ++f) {
    const FieldInfo& row = field_table[f];
    if (planned.has(static_cast<Field>(f))) all.push_back({row.name, row.unit, row.meaning});
  }
  return all;
}

std::vector<double> Simulation::State::values_of_state(Field field) const {
  const bool vectors = components(info(field).type) == 2;
  std::vector<double> numbers;
  if (!simulator.failure()) {
    numbers = simulator.reals(field);
    for (size_t k = 0; field == Field::x_in && k < numbers.size(); ++k)
      numbers[k] += scene.domain_min[static_cast<int>(k % 2)];
  } else if (vectors) {
    for (const Vec2 each : field == Field::x_in ? now().x : now().v)
      numbers.insert(numbers.end(), {each.x, each.y});
  } else {
    numbers = field == Field::rho ? now().density : now().pressure;
  }
  return numbers;
}

FieldView Simulation::State::keep(std::string_view name, std::vector<std::byte> bytes, NumberType type,
                                  size_t columns) const {
  std::vector<std::byte>& kept = values[std::string(name)] = std::move(bytes);
  return {kept, type, kept.size() / size_of(type) / columns, columns};
}

Field Simulation::State::planned(std::string_view name, std::string_view more) const {
  const FieldSet fields = simulator.plan().fields();
  const auto row = std::ranges::find(field_table, name, &FieldInfo::name);
  const auto field = static_cast<Field>(row - field_table.begin());
  if (row != field_table.end() && fields.has(field)) return field;
  std::string names(more);
  for (uint32_t f = 0; f < field_count; ++f)
    if (fields.has(static_cast<Field>(f)))
      names += fmt::format("{}{}", names.empty() ? "" : ", ", field_table[f].name);
  throw InputError(fmt::format("{}: found no field {}, expected one of {}", scene.file, name, names));
}

FieldView Simulation::field(std::string_view name) const {
  const auto kept = [&](const auto& values, size_t columns) {
    return state_->keep(name, copied(values), NumberType::float64, columns);
  };
  const auto of_state =
      std::ranges::find(state_fields, name, [](const StateField& each) { return each.description.name; });
  if (of_state != state_fields.end())
    return kept(state_->values_of_state(of_state->field), components(info(of_state->field).type));
  const Field field = state_->planned(name, "position, velocity, density, pressure");
  const size_t columns = components(info(field).type);
  if (!is_integer(field) && info(field).length == Length::fluid)
    return kept(state_->simulator.reals(field), columns);
  const FieldValues values = values_of(state_->backend(), field, state_->simulator.sizes());
  if (is_integer(field)) return state_->keep(name, copied(values.integers), NumberType::uint32, columns);
  return kept(values.reals, columns);
}

FieldView Simulation::field_in_memory(std::string_view name) const {
  const Field field = state_->planned(name, "");
  const size_t columns = components(info(field).type);
  const bool in_float = device().precision() == Precision::single_;
  const NumberType type = is_integer(field) ? NumberType::uint32
                          : in_float        ? NumberType::float32
                                            : NumberType::float64;
  if (const auto bytes = state_->backend().memory(field); !bytes.empty()) {
    const Length length = info(field).length;
    const bool grows = length == Length::list || length == Length::gradients;
    return {bytes, type, bytes.size() / size_of(type) / columns, columns, !grows};
  }
  const FieldValues values = values_of(state_->backend(), field, state_->simulator.sizes());
  const std::string kept = fmt::format("{} in memory", name);
  if (type == NumberType::uint32) return state_->keep(kept, copied(values.integers), type, columns);
  if (type == NumberType::float64) return state_->keep(kept, copied(values.reals), type, columns);
  return state_->keep(kept, copied(std::vector<float>(values.reals.begin(), values.reals.end())), type,
                      columns);
}

PointValues Simulation::values_at(Vec2 point) const {
  return sluice::values_at(state_->scene, state_->now(), point);
}

std::vector<std::pair<std::string, std::optional<double>>> Simulation::probes() const {
  const std::vector<std::string> names = probe_columns(state_->scene);
  const auto values = probe_values(state_->scene, state_->now());
  std::vector<std::pair<std::string, std::optional<double>>> probes;
  for (size_t k = 0; k < names.size(); ++k) probes.emplace_back(names[k], values[k]);
  return probes;
}

std::vector<std::pair<std::string, WallForce>> Simulation::wall_forces() const {
  const State& s = *state_;
  if (!s.walls) s.walls.emplace(s.scene, s.samples);
  const auto forces = s.walls->in(s.backend(), s.simulator.sizes());
  std::vector<std::pair<std::string, WallForce>> named;
  for (size_t k = 0; k < forces.size(); ++k) named.emplace_back(name_of(s.scene.boundary[k]), forces[k]);
  return named;
}

void Simulation::report_sweeps() { state_->simulator.report_sweeps(); }

void Simulation::set_positions(std::span<const Vec2> x) {
  state_->forget();
  state_->simulator.set_positions(x);
}

void Simulation::set_velocities(std::span<const Vec2> v) {
  state_->forget();
  state_->simulator.set_velocities(v);
}

void Simulation::write_state(const std::filesystem::path& path) const {
  OutputFile file(path);
  sluice::write_state(file, snapshot(), device().precision());
}

void Simulation::write_checkpoint(const std::filesystem::path& path) const {
  if (failure()) {
    throw InputError(fmt::format(
        "{}: found a simulation that became invalid, expected a valid one for a checkpoint", path.string()));
  }
  CheckpointWriter(path, state_->scene, device().precision(),
                   fmt::format("{}, {}", device().name(), device().description()))
      .write(state_->simulator.state(), state_->statistics.counts());
}

std::string Simulation::summary() const {
  const State& s = *state_;
  const RunSummary summary{s.scene, s.samples, *s.device.backend_, s.simulator, s.statistics, s.watch, ""};
  return to_json(summary).dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
}

}  // namespace sluice
