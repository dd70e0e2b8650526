// What the simulator needs of a machine: hold the fields, run a stage. The CPU backend is cpu/backend.hpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/model/fields.hpp"
#include "core/model/params.hpp"
#include "core/model/stages.hpp"
#include "sluice/choices.hpp"

namespace sluice {

class Backend {
 public:
  virtual ~Backend() = default;

  /// Makes room for `fields`, zeroed, and drops all others. Throws EnvironmentError when memory runs out.
  virtual void allocate(FieldSet fields, const Sizes& sizes) = 0;
  /// Grows the neighbour list to `entries`; what it held is lost.
  virtual void resize_list(uint64_t entries) = 0;
  /// Sets the constants and the needs of all stages that are run from now on.
  virtual void configure(const Params& params, const Needs& needs) = 0;

  virtual void run(Stage stage) = 0;
  /// Runs `stages`, a sweep of the pressure solve, `times` times, or until Field::sweeps says that the solve
  /// is over. How often that is looked at is up to the backend; no sweep after the last one changes the
  /// pressure.
  virtual void sweep(const std::vector<Stage>& stages, uint32_t times);
  /// Exchanges the contents of two fields of one type and length, without copying.
  virtual void swap(Field a, Field b) = 0;

  /// Copies a whole field; vectors are interleaved (x0 y0 x1 y1 ...). Sizes must match.
  virtual void upload(Field field, std::span<const double> values) = 0;
  virtual void upload(Field field, std::span<const uint32_t> values) = 0;
  virtual void download(Field field, std::span<double> values) const = 0;
  virtual void download(Field field, std::span<uint32_t> values) const = 0;
  /// Bytes of a field where they lie, if that is the processor's own memory; else none.
  virtual std::span<const std::byte> memory(Field) const { return {}; }

  /// Seconds spent in `stage` since reset_seconds.
  virtual double seconds(Stage stage) const = 0;
  virtual void reset_seconds() = 0;

  virtual std::string name() const = 0;    ///< "cpu", "gpu"
  virtual std::string device() const = 0;  ///< what it runs on, for people
  virtual Precision precision() const = 0;
  virtual int threads() const = 0;

 protected:
  /// Runs the stages of a sweep once, one after the other.
  virtual void run_sweep(const std::vector<Stage>& stages);
};

}  // namespace sluice
