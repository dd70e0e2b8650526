// Steps in repetitions, sweeps in turns, and the count of bytes.
#include "bench/gpu_times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "bench/yardstick.hpp"
#include "cpu/backend.hpp"

namespace sluice::bench {
namespace {

constexpr int step_repetitions = 15, sweep_repetitions = 15;
constexpr double yardstick_tolerance = 1e-4;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// What a step starts from, kept so that every repetition is the same steps again.
class State {
 public:
  explicit State(Case& subject) : backend_(subject.backend()), id_(subject.n()) {
    backend_.download(Field::id, id_);
    for (const Field field : {Field::x_in, Field::v_in, Field::p, Field::rho}) {
      const size_t components = info(field).type == Type::vec2 ? 2 : 1;
      reals_.emplace_back(field, std::vector<double>(components * subject.n()));
      backend_.download(field, reals_.back().second);
    }
  }
  /// Returns when everything is on the device.
  void restore() {
    for (const auto& [field, values] : reals_) backend_.upload(field, values);
    backend_.upload(Field::id, id_);
    backend_.download(Field::id, id_);
  }

 private:
  Backend& backend_;
  std::vector<uint32_t> id_;
  std::vector<std::pair<Field, std::vector<double>>> reals_;
};

uint32_t steps_per_repetition(uint32_t size) { return std::clamp(1'000'000 / size, 3u, 10u); }

template <class F>
double wall_seconds(F&& f) {
  const auto start = std::chrono::steady_clock::now();
  f();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

uint64_t entries_of(Case& subject) {
  std::vector<uint32_t> list(size_t{2} * subject.n());
  subject.backend().download(Field::list, list);
  uint64_t entries = 0;
  for (size_t i = 1; i < list.size(); i += 2) entries += list[i];
  return entries;
}

/// One repetition.
StepTimes time_some_steps(Case& subject) {
  const uint32_t steps = steps_per_repetition(subject.key().size);
  const Plan& plan = subject.plan();
  std::array<uint64_t, stage_count> runs{};
  uint64_t sweeps = 0;
  subject.backend().reset_seconds();
  StepTimes times;
  times.step = wall_seconds([&] {
                 for (uint32_t i = 0; i < steps; ++i) sweeps += subject.step().iterations;
               }) /
               steps;
  for (const PhaseInfo& phase : phase_table) {
    if (phase.runs == Runs::once) continue;
    for (const Stage stage : plan[phase.phase])
      runs[static_cast<size_t>(stage)] += phase.runs == Runs::until_solved ? sweeps : steps;
  }
  for (size_t i = 0; i < stage_count; ++i) {
    const double seconds = subject.backend().seconds(static_cast<Stage>(i));
    times.in_stages += seconds / steps;
    times.stage[i] = runs[i] > 0 ? seconds / static_cast<double>(runs[i]) : std::nan("");
  }
  for (const Stage stage : plan[Phase::sweep]) times.sweep += times.stage[static_cast<size_t>(stage)];
  return times;
}

CaseKey on_gpu(uint32_t size) { return {PressureMethod::iisph, size, Precision::single_, 1, Machine::gpu}; }
CaseKey on_cpu(uint32_t size) {
  return {PressureMethod::iisph, size, Precision::single_, cpu::hardware_threads()};
}

/// Whole sweeps as a step runs them.
void run_sweeps(Case& subject, uint32_t times) {
  std::array<uint32_t, 2> sweeps{};
  subject.backend().upload(Field::sweeps, sweeps);
  subject.backend().sweep(subject.plan()[Phase::sweep], times);
  subject.backend().download(Field::sweeps, sweeps);
  if (sweeps[0] != times) throw std::runtime_error(fmt::format("{} sweeps instead of {}", sweeps[0], times));
}

}  // namespace

StepTimes time_steps(Case& subject) {
  State start(subject);
  StepTimes best = time_some_steps(subject);
  for (int repetition = 1; repetition < step_repetitions; ++repetition) {
    start.restore();
    const StepTimes times = time_some_steps(subject);
    if (times.step < best.step) {
      best.step = times.step;
      best.in_stages = times.in_stages;
    }
    best.sweep = std::min(best.sweep, times.sweep);
    for (size_t i = 0; i < stage_count; ++i) best.stage[i] = std::min(best.stage[i], times.stage[i]);
  }
  best.n = subject.n();
  const uint64_t entries = entries_of(subject);
  best.neighbours = static_cast<double>(entries) / subject.n();
  best.sweep_bytes = sweep_bytes(subject.plan(), subject.n(), entries);
  return best;
}

StepPair compare_steps(uint32_t size, const gpu::Context& context) {
  Case gpu(on_gpu(size), &context), cpu(on_cpu(size));
  State gpu_start(gpu), cpu_start(cpu);
  StepPair best{gpu.n(), infinity, infinity};
  for (int repetition = 0; repetition < step_repetitions; ++repetition) {
    gpu_start.restore();
    best.gpu = std::min(best.gpu, time_some_steps(gpu).step);
    cpu_start.restore();
    best.cpu = std::min(best.cpu, time_some_steps(cpu).step);
  }
  return best;
}

SweepTimes compare_sweeps(uint32_t size, const gpu::Context& context) {
  Case gpu(on_gpu(size), &context), cpu(on_cpu(size));
  gpu.freeze();
  cpu.freeze();
  Yardstick yardstick(gpu.backend(), gpu.params(), gpu.samples());
  run_sweeps(gpu, 1);
  yardstick.sweep();
  const double difference = yardstick.difference(gpu.backend());
  if (!(difference <= yardstick_tolerance)) {
    throw std::runtime_error(
        fmt::format("{}: the yardstick's pressures differ from the GPU's by {:.2g}", size, difference));
  }
  SweepTimes best{gpu.n(), infinity, infinity, infinity};
  const auto keep = [](double& fastest, double seconds) {
    fastest = std::min(fastest, seconds / sweeps_per_step);
  };
  for (int repetition = 0; repetition < sweep_repetitions; ++repetition) {
    keep(best.gpu, wall_seconds([&] { run_sweeps(gpu, sweeps_per_step); }));
    keep(best.cpu, wall_seconds([&] { run_sweeps(cpu, sweeps_per_step); }));
    keep(best.yardstick, wall_seconds([&] {
           for (uint32_t i = 0; i < sweeps_per_step; ++i) yardstick.sweep();
         }));
  }
  return best;
}

double sweep_bytes(const Plan& plan, uint64_t n, uint64_t entries) {
  const Sizes sizes{n, 0, 0, entries};
  double bytes = 0;
  for (const Stage stage : plan[Phase::sweep]) {
    for (const FieldSet fields : {reads_of(stage, plan.needs), writes_of(stage, plan.needs)}) {
      for (uint32_t i = 0; i < field_count; ++i) {
        if (!fields.has(static_cast<Field>(i))) continue;
        bytes += static_cast<double>(sizes.of(field_table[i].length)) * element_bytes(field_table[i].type, 4);
      }
    }
  }
  return bytes;
}

}  // namespace sluice::bench
