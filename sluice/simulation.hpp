// A simulation: a scene and what computes it, stepped, read and changed from a program of one's own. It owns
// all that it needs: nothing has to outlive it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sluice/error.hpp"
#include "sluice/report.hpp"
#include "sluice/sampling.hpp"
#include "sluice/scene.hpp"

namespace sluice {

class Backend;

/// What a simulation is computed on. cpu::device() makes one (sluice/cpu.hpp), and gpu::device()
/// (sluice/gpu.hpp).
class Device {
 public:
  explicit Device(std::unique_ptr<Backend> backend);
  ~Device();
  Device(Device&&) noexcept;
  Device& operator=(Device&&) noexcept;

  std::string name() const;         ///< "cpu" or "gpu"
  std::string description() const;  ///< name of the processor or of the graphics card, for people
  Precision precision() const;
  int threads() const;

 private:
  friend class Simulation;
  std::unique_ptr<Backend> backend_;
};

enum class NumberType { float32, float64, uint32 };

/// Description of a field: of particles, boundary samples, grid cells, entries of the neighbour list, ...
struct FieldDescription {
  std::string_view name, unit, meaning;
};

/// Values of a field, until the simulation that they are from changes, moves or ends. Row after row: those of
/// a vector are x0 y0 x1 y1 ...
struct FieldView {
  std::span<const std::byte> bytes;
  NumberType type = NumberType::float64;
  size_t rows = 0, columns = 1;
  bool in_place =
      false;  ///< the memory that is computed in; it stays there, with other values after each step

  /// The numbers as double, float or uint32_t. InputError when they are of another type.
  template <class T>
  std::span<const T> as() const;
};

class Simulation {
 public:
  /// Sets up the start of `scene`: sampled, and relaxed if the scene asks for it. InputError as of
  /// load_scene, and when there is not enough memory for it.
  Simulation(Scene scene, Device device);
  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  /// Goes on from a checkpoint of `sluice run --checkpoint` or write_checkpoint(): every later step has the
  /// bits that it has in the run which wrote it. InputError when it is none, or of another precision than the
  /// device's.
  static Simulation resume(const std::filesystem::path& checkpoint, Device device);

  /// Runs one step. Where the scene's steps adapt, they are shortened to end at the time `end`. failure()
  /// says afterwards whether the state that it led to is valid; if not, another step is an InputError.
  StepReport step(double end = std::numeric_limits<double>::infinity());
  /// Steps until time() has reached `time`, or a step failed, or `after_step`, if given, returned false.
  void run(double time, const std::function<bool(const StepReport&)>& after_step = {});

  const Scene& scene() const&;
  Scene scene() &&;
  /// Particles and boundary samples as the scene lays them.
  const Samples& samples() const&;
  Samples samples() &&;
  const Device& device() const;
  size_t particles() const;

  uint64_t steps() const;
  double time() const;
  double dt() const;  ///< length of the last step, or of the next where steps do not adapt
  std::optional<Failure> failure() const;
  /// What tends to go wrong with the scene and is known before the first step, for people.
  std::vector<std::string> warnings() const;

  /// State after the last step, or the last finite one before it.
  Snapshot snapshot() const;

  /// The fields there are: position, velocity, density and pressure of the state that the last step led to,
  /// and every array that its stages worked with.
  std::vector<FieldDescription> fields() const;

  /// Values of a field by its name. Reals of particles are in the order of ids and in double, whatever the
  /// precision: position and velocity as after the last step, density and pressure as computed in it, all
  /// others as its stages left them. What counts cells, samples, list entries or particles by their place in
  /// memory is as it lies there. InputError for a name that is not in fields().
  FieldView field(std::string_view name) const;

  /// Values of one of the stages' arrays, particles in the order of the memory (the field `id` says whose
  /// they are), in the numbers that it is computed in; without a copy where that is the processor's own
  /// memory. InputError for a name that the stages do not have.
  FieldView field_in_memory(std::string_view name) const;

  /// Values at a point, as a probe of the scene has them (docs/output.md).
  PointValues values_at(Vec2 point) const;
  /// What the probes of the scene measure now, under the names of their columns; nothing where a line meets
  /// no fluid.
  std::vector<std::pair<std::string, std::optional<double>>> probes() const;
  /// Forces on the boundary shapes in the last step, under their names.
  std::vector<std::pair<std::string, WallForce>> wall_forces() const;
  /// Has every step report the sweeps of its pressure solve from now on.
  void report_sweeps();

  /// Sets the positions, or velocities, that the next step starts from, in the order of ids. InputError when
  /// there are not as many as particles, or one is not finite.
  void set_positions(std::span<const Vec2> x);
  void set_velocities(std::span<const Vec2> v);

  /// Writes what `sluice run --state` writes.
  void write_state(const std::filesystem::path& path) const;
  /// Writes what `sluice run --checkpoint` writes. InputError after a failure.
  void write_checkpoint(const std::filesystem::path& path) const;
  /// What `sluice run --summary` writes: counts, means, extremes, timings and settings, as JSON.
  std::string summary() const;

 private:
  struct State;
  explicit Simulation(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace sluice
