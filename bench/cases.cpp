#include "bench/cases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/text.hpp"
#include "cpu/backend.hpp"
#include "gpu/backend.hpp"
#include "sluice/load.hpp"

namespace sluice::bench {
namespace {

constexpr int steps_before = 10;

/// Spacing at which the dam, 240 high and 200 - 3h wide, has `size` particles.
double spacing_for(uint32_t size) {
  const double n = size, height = 240, width = 200;
  return (-3 * height + std::sqrt(9 * height * height + 4 * n * height * width)) / (2 * n);
}

std::unique_ptr<Backend> make_backend(const CaseKey& key, const gpu::Context* context) {
  if (key.machine == Machine::cpu) return cpu::make_backend(key.precision, key.threads, key.instructions);
  if (context == nullptr || key.precision != Precision::single_)
    throw std::logic_error(key.name() + " wants an OpenGL context and float");
  return gpu::make_backend(*context);
}

/// The box, whose block has 40 columns and 30 rows, with `size` particles in it.
Scene make_box(uint32_t size) {
  const double refinement = std::sqrt(size / 1200.0), h = 0.05 / refinement;
  const std::vector<std::string> overrides = {
      fmt::format("particles.spacing={:.4}", h), fmt::format("time.dt={:.4}", 0.02 * h), "fluid.jitter=0.1",
      fmt::format("fluid.rect.0.count=[{:.0f},{:.0f}]", 40 * refinement, 30 * refinement)};
  return load_scene("wcsph_box", overrides);
}

}  // namespace

std::string size_text(uint32_t size) {
  if (size >= 1'000'000) return fmt::format("{}M", size / 1'000'000);
  return fmt::format("{:g}k", size / 1000.0);
}

std::string CaseKey::name() const {
  const std::string set =
      instructions == cpu::widest_instructions() ? "" : fmt::format("-{}", name_of(instructions));
  return fmt::format("{}/{}/{}/{}", name_of(method), size_text(size), name_of(precision),
                     machine == Machine::gpu ? "gpu" : std::to_string(threads) + set);
}

Scene make_scene(const CaseKey& key) {
  if (key.method == PressureMethod::wcsph) return make_box(key.size);
  const double h = spacing_for(key.size), dt = (key.method == PressureMethod::iisph ? 0.005 : 0.001) * h;
  const std::vector<std::string> overrides = {
      fmt::format("particles.spacing={:.4}", h), fmt::format("time.dt={:.4}", dt), "viscosity.coefficient=2",
      "fluid.jitter=0.1", fmt::format("pressure.method={}", name_of(key.method)),
      fmt::format("pressure.iisph.min_iterations={}", sweeps_per_step),
      fmt::format("pressure.iisph.max_iterations={}", sweeps_per_step),
      // What `source` does to p is then the same however often it runs.
      "pressure.iisph.warm_start=1"};
  return load_scene("breaking_dam", overrides);
}

PressureMethod timed_with(Stage stage) {
  for (const PressureMethod method : methods) {
    const std::vector<Stage> planned = make_plan(model_of(make_scene({method}))).stages();
    if (std::find(planned.begin(), planned.end(), stage) != planned.end()) return method;
  }
  throw std::logic_error(fmt::format("{} is in no plan that is timed", info(stage).name));
}

Case::Case(const CaseKey& key, const gpu::Context* context)
    : key_(key),
      scene_(make_scene(key)),
      samples_(sample(scene_)),
      params_(make_params(scene_, static_cast<uint32_t>(samples_.fluid.size()))),
      backend_(make_backend(key, context)),
      simulator_(std::make_unique<Simulator>(scene_, samples_, *backend_)) {
  for (int i = 0; i < steps_before; ++i) step();
}

StepReport Case::step() {
  if (frozen_) throw std::logic_error("a frozen case does not step");
  const StepReport report = simulator_->step();
  if (simulator_->failure()) throw std::runtime_error(key_.name() + ": " + simulator_->failure()->reason);
  return report;
}

void Case::freeze() {
  frozen_ = true;
  backend_->swap(Field::id, Field::id_in);
  backend_->swap(Field::p, Field::p_in);
  backend_->swap(Field::rho, Field::rho_in);
  run(plan()[Phase::sort]);
  run(plan()[Phase::search]);
  uint32_t needed = 0;
  backend_->download(Field::list_needed, std::span(&needed, 1));
  if (needed > first_list_size(n(), scene_.smoothing)) {
    throw std::runtime_error(key_.name() +
                             ": the neighbour list is too short, its stages would be timed wrongly");
  }
  run(plan()[Phase::forces]);
  start_solve();
  run(plan()[Phase::sweep]);
  run({Stage::pressure_acceleration});
}

void Case::start_solve() {
  if (plan().sweeps()) backend_->upload(Field::sweeps, std::array<uint32_t, 2>{});
}

void Case::run(const std::vector<Stage>& stages) {
  for (const Stage stage : stages) backend_->run(stage);
}

void Case::preserving(const std::vector<Stage>& stages, const std::function<void()>& f) {
  struct Saved {
    Field field;
    std::vector<double> values;
  };
  std::vector<Saved> saved;
  for (uint32_t i = 0; i < field_count; ++i) {
    const Field field = static_cast<Field>(i);
    const FieldInfo& facts = info(field);
    bool written = false;
    for (const Stage stage : stages) written = written || writes_of(stage, plan().needs).has(field);
    if (!written || facts.length != Length::fluid || is_integer(field)) continue;
    const size_t components = element_bytes(facts.type, sizeof(double)) / sizeof(double);
    saved.push_back({field, std::vector<double>(n() * components)});
    backend_->download(field, saved.back().values);
  }
  f();
  for (const Saved& before : saved) backend_->upload(before.field, before.values);
}

Case& CaseStore::stepping(const CaseKey& key) {
  if (last_ && last_->key() == key && !last_->frozen()) return *last_;
  last_.reset();  // before the next is made: two large cases need not fit into memory
  last_ = std::make_unique<Case>(key);
  return *last_;
}

Case& CaseStore::frozen(const CaseKey& key) {
  if (last_ && last_->key() == key && last_->frozen()) return *last_;
  stepping(key).freeze();
  return *last_;
}

}  // namespace sluice::bench
