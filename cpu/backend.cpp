// Allocation, transfers, and the switch from a stage of the table to its function.
#include "cpu/backend.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <new>
#include <stdexcept>
#include <type_traits>

#include "cpu/simd/sweep.hpp"
#include "cpu/stage_functions.hpp"
#include "sluice/error.hpp"

namespace sluice::cpu {
namespace {

template <class T>
void resize_to(std::vector<T>& values, uint64_t size) {
  values = std::vector<T>();
  values.resize(size);
}

/// Calls f with the vector of `field`.
template <class AnyState, class F>
void visit_field(AnyState& state, Field field, F&& f) {
  switch (field) {
#define FIELD(name, type, length, need, unit, meaning) \
  case Field::name: f(state.name); return;
    SLUICE_FIELDS(FIELD)
#undef FIELD
    case Field::count: break;
  }
}

/// Whether elements of type T are made of uints, and not of reals.
template <class T>
constexpr bool is_uint = std::is_same_v<T, uint32_t> || std::is_same_v<T, glm::uvec2>;

template <class Scalar, class T>
auto scalars(std::vector<T>& values) {
  return std::span(reinterpret_cast<Scalar*>(values.data()), values.size() * sizeof(T) / sizeof(Scalar));
}
template <class Scalar, class T>
auto scalars(const std::vector<T>& values) {
  return std::span(reinterpret_cast<const Scalar*>(values.data()),
                   values.size() * sizeof(T) / sizeof(Scalar));
}

template <class From, class To>
void copy_converted(std::span<const From> from, std::span<To> to, Field field) {
  if (from.size() != to.size()) {
    throw std::logic_error(
        fmt::format("field {}: {} values for {}", info(field).name, from.size(), to.size()));
  }
  for (size_t i = 0; i < from.size(); ++i) to[i] = static_cast<To>(from[i]);
}

template <class Real>
class CpuBackend final : public Backend {
 public:
  CpuBackend(int threads, Instructions instructions)
      : threads_(threads), stages_(functions_with<Real>(instructions)) {}

  void allocate(FieldSet fields, const Sizes& sizes) override {
    state_.sizes = sizes;
    state_.part_needs.clear();
    // A thread pays for itself only with some work to do.
    const uint64_t useful = sizes.fluid / particles_per_thread + 1;
    state_.threads = static_cast<int>(std::min<uint64_t>(static_cast<uint64_t>(threads_), useful));
    try {
      for (uint32_t i = 0; i < field_count; ++i) {
        const Field field = static_cast<Field>(i);
        const uint64_t size = fields.has(field) ? sizes.of(info(field).length) : 0;
        visit_field(state_, field, [&](auto& values) { resize_to(values, size); });
      }
    } catch (const std::bad_alloc&) {
      throw EnvironmentError(fmt::format(
          "out of memory for {} particles; close other programs or use fewer particles", sizes.fluid));
    }
  }

  void resize_list(uint64_t entries) override {
    state_.sizes.list = entries;
    try {
      resize_to(state_.index, state_.sizes.of(Length::list));
      resize_to(state_.gradient, state_.sizes.of(Length::gradients));
    } catch (const std::bad_alloc&) {
      throw EnvironmentError(
          fmt::format("out of memory for a neighbour list of {} entries; particles crowd together, use a "
                      "smaller time step",
                      entries));
    }
  }

  void configure(const Params& params, const Needs& needs) override {
    state_.params = params.to<Real>();
    state_.needs = needs;
  }

  void run(Stage stage) override {
    const auto start = std::chrono::steady_clock::now();
    stages_.all[static_cast<uint32_t>(stage)](state_);
    time_of(stage) += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  void swap(Field a, Field b) override {
    visit_field(state_, a, [&]<class A>(A& left) {
      visit_field(state_, b, [&]<class B>(B& right) {
        if constexpr (std::is_same_v<A, B>) {
          left.swap(right);
        } else {
          throw std::logic_error("swap of fields of different types");
        }
      });
    });
  }

  void upload(Field field, std::span<const double> values) override {
    visit_field(state_, field, [&]<class T>(std::vector<T>& to) {
      if constexpr (is_uint<T>)
        throw std::logic_error("reals for a field of integers");
      else
        copy_converted(values, scalars<Real>(to), field);
    });
  }

  void upload(Field field, std::span<const uint32_t> values) override {
    visit_field(state_, field, [&]<class T>(std::vector<T>& to) {
      if constexpr (!is_uint<T>)
        throw std::logic_error("integers for a field of reals");
      else
        copy_converted(values, scalars<uint32_t>(to), field);
    });
    if (field == Field::list || field == Field::index) state_.reach = state_.any_reach;
  }

  void download(Field field, std::span<double> values) const override {
    visit_field(state_, field, [&]<class T>(const std::vector<T>& from) {
      if constexpr (is_uint<T>)
        throw std::logic_error("reals from a field of integers");
      else
        copy_converted(scalars<Real>(from), values, field);
    });
  }

  void download(Field field, std::span<uint32_t> values) const override {
    visit_field(state_, field, [&]<class T>(const std::vector<T>& from) {
      if constexpr (!is_uint<T>)
        throw std::logic_error("integers from a field of reals");
      else
        copy_converted(scalars<uint32_t>(from), values, field);
    });
  }

  std::span<const std::byte> memory(Field field) const override {
    std::span<const std::byte> bytes;
    visit_field(state_, field, [&](const auto& values) { bytes = std::as_bytes(std::span(values)); });
    return bytes;
  }

  double seconds(Stage stage) const override { return seconds_[static_cast<uint32_t>(stage)]; }
  void reset_seconds() override { seconds_.fill(0); }

  std::string name() const override { return "cpu"; }
  std::string device() const override { return processor_name(); }
  Precision precision() const override {
    return std::is_same_v<Real, double> ? Precision::double_ : Precision::single_;
  }
  int threads() const override { return threads_; }

 private:
  static constexpr uint64_t particles_per_thread = 1500;

  /// Two of the stages go over the list together, where they can be run part by part.
  void run_sweep(const std::vector<Stage>& stages) override {
    for (size_t s = 0; s < stages.size(); ++s) {
      const bool together = stages_.pressure_acceleration != nullptr &&
                            stages[s] == Stage::pressure_acceleration && s + 1 < stages.size() &&
                            stages[s + 1] == Stage::pressure_operator;
      if (!together) {
        run(stages[s]);
        continue;
      }
      const auto [seconds, share] =
          run_both(state_, stages_.pressure_acceleration, stages_.pressure_operator);
      time_of(stages[s]) += seconds * share;
      time_of(stages[++s]) += seconds * (1 - share);
    }
  }

  double& time_of(Stage stage) { return seconds_[static_cast<uint32_t>(stage)]; }

  int threads_;
  StageFunctions<Real> stages_;
  State<Real> state_;
  std::array<double, stage_count> seconds_{};
};

#if defined(__x86_64__)
/// What cpu/simd/instructions.hpp compiles for.
bool processor_knows(Instructions instructions) {
  const auto all = [](auto... known) { return (... && (known != 0)); };
  switch (instructions) {
    case Instructions::avx2:
      return all(__builtin_cpu_supports("avx2"), __builtin_cpu_supports("bmi2"),
                 __builtin_cpu_supports("popcnt"));
    case Instructions::avx512:
      return all(__builtin_cpu_supports("avx512f"), __builtin_cpu_supports("avx512bw"),
                 __builtin_cpu_supports("avx512dq"), __builtin_cpu_supports("avx512vl"),
                 __builtin_cpu_supports("bmi2"), __builtin_cpu_supports("popcnt"));
    case Instructions::plain:
    case Instructions::baseline: break;
  }
  return true;
}
#else
bool processor_knows(Instructions instructions) { return instructions <= Instructions::baseline; }
#endif

}  // namespace

std::unique_ptr<Backend> make_backend(Precision precision, int threads, Instructions instructions) {
  if (!std::ranges::count(available_instructions(), instructions))
    throw std::invalid_argument("this processor, or this build, does not have these instructions");
  if (precision == Precision::double_) return std::make_unique<CpuBackend<double>>(threads, instructions);
  return std::make_unique<CpuBackend<float>>(threads, instructions);
}

std::vector<Instructions> available_instructions() {
  std::vector<Instructions> available = {Instructions::plain};
#define SET(set) \
  if (processor_knows(Instructions::set)) available.push_back(Instructions::set);
  SLUICE_SIMD_SETS(SET)
#undef SET
  return available;
}

Instructions widest_instructions() { return available_instructions().back(); }

std::string names_of(const std::vector<Instructions>& instructions) {
  std::string names;
  for (const Instructions each : instructions)
    names += fmt::format("{}{}", names.empty() ? "" : ", ", name_of(each));
  return names;
}

int hardware_threads() { return omp_get_num_procs(); }

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "CPU";
}

}  // namespace sluice::cpu
