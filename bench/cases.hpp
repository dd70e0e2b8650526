// What the benchmarks run on: the breaking dam, or for WCSPH the box, refined to a number of particles and
// brought off its lattice.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/model/params.hpp"
#include "core/solver/simulator.hpp"
#include "cpu/backend.hpp"
#include "sluice/sampling.hpp"

namespace sluice::gpu {
class Context;
}

namespace sluice::bench {

enum class Machine { cpu, gpu };

struct CaseKey {
  PressureMethod method = PressureMethod::iisph;
  uint32_t size = 1000;  ///< about as many fluid particles
  Precision precision = Precision::single_;
  int threads = 1;  ///< of the CPU backend
  Machine machine = Machine::cpu;
  cpu::Instructions instructions = cpu::widest_instructions();  ///< of the CPU backend

  bool operator==(const CaseKey&) const = default;
  /// "iisph/1k/float/2", "iisph/1k/float/gpu"; "iisph/1k/float/2-plain" unless with the widest instructions
  std::string name() const;
};

inline constexpr std::array methods = {PressureMethod::iisph, PressureMethod::ssph, PressureMethod::wcsph};

/// The first of the methods whose plan has `stage`: the one it is timed with.
PressureMethod timed_with(Stage stage);

/// Particles in the runs of another program that WCSPH steps are compared with.
inline constexpr uint32_t peer_size = 7'200;

/// Sweeps of every IISPH step that is timed: fixed, so that steps are the same work at all sizes.
inline constexpr uint32_t sweeps_per_step = 5;

/// Sizes as the tables name them: "1k", "1M".
std::string size_text(uint32_t size);

/// The scene of `key`: breaking dam with viscosity 2, dt = 0.005 h (SSPH 0.001 h), or for WCSPH the box with
/// dt = 0.02 h; a jitter of 0.1 h.
Scene make_scene(const CaseKey& key);

class Case {
 public:
  /// Runs a few steps, after which particles are neither on a lattice nor sorted perfectly. `context` is for
  /// the GPU, and outlives this.
  explicit Case(const CaseKey& key, const gpu::Context* context = nullptr);
  // The simulator refers to the members.
  Case(const Case&) = delete;
  Case& operator=(const Case&) = delete;

  const CaseKey& key() const { return key_; }
  uint32_t n() const { return params_.n; }
  const Params& params() const { return params_; }
  const Samples& samples() const { return samples_; }
  const Plan& plan() const { return simulator_->plan(); }
  Backend& backend() { return *backend_; }

  /// Runs a step; throws when the run is no longer valid. Not after freeze().
  StepReport step();

  /// Walks into the next step up to and with one sweep, and stays there: every stage's input is in place.
  void freeze();
  bool frozen() const { return frozen_; }

  /// The sweep that is run next is the first of its solve.
  void start_solve();

  void run(const std::vector<Stage>& stages);

  /// Calls `f`, which runs `stages` any number of times, and then puts back what they changed, so that those
  /// timed later find the same input.
  void preserving(const std::vector<Stage>& stages, const std::function<void()>& f);

 private:
  CaseKey key_;
  Scene scene_;
  Samples samples_;
  Params params_;
  std::unique_ptr<Backend> backend_;
  std::unique_ptr<Simulator> simulator_;
  bool frozen_ = false;
};

/// Makes cases and keeps the last one, since making one takes longer than timing it.
class CaseStore {
 public:
  Case& stepping(const CaseKey& key);
  Case& frozen(const CaseKey& key);

 private:
  std::unique_ptr<Case> last_;
};

}  // namespace sluice::bench
