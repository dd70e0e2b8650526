// Two backends held against each other: stage by stage from identical input, and one after the other within a
// step. Both classes are backends themselves, so that the simulator walks its plan on them as on any other.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/agree/comparison.hpp"
#include "core/solver/backend.hpp"

namespace sluice {

/// Values of a field, all of them; one of the two vectors is empty.
struct FieldValues {
  std::vector<double> reals;
  std::vector<uint32_t> integers;
};
FieldValues values_of(const Backend& backend, Field field, const Sizes& sizes);
void put_values(Backend& backend, Field field, const FieldValues& values);

/// Neighbour lists particle by particle, wherever a backend keeps its slices.
struct NeighbourLists {
  std::vector<uint32_t> lengths, index;
  std::vector<double> gradient;
};
NeighbourLists lists_of(const Backend& backend, const Sizes& sizes);

/// Values of one field on two backends; those of the neighbour list particle by particle.
struct WatchedField {
  Field field;
  FieldValues reference, other;
};

/// A backend on which nothing but forwarding happens.
class ForwardingBackend : public Backend {
 public:
  explicit ForwardingBackend(Backend& first) : active_(&first) {}
  void allocate(FieldSet fields, const Sizes& sizes) override { active_->allocate(fields, sizes); }
  void resize_list(uint64_t entries) override { active_->resize_list(entries); }
  void configure(const Params& params, const Needs& needs) override { active_->configure(params, needs); }
  void run(Stage stage) override { active_->run(stage); }
  // Sweeps are run stage by stage, so that those who look at stages see all of them.
  void swap(Field a, Field b) override { active_->swap(a, b); }
  void upload(Field field, std::span<const double> values) override { active_->upload(field, values); }
  void upload(Field field, std::span<const uint32_t> values) override { active_->upload(field, values); }
  void download(Field field, std::span<double> values) const override { active_->download(field, values); }
  void download(Field field, std::span<uint32_t> values) const override { active_->download(field, values); }
  double seconds(Stage stage) const override { return active_->seconds(stage); }
  void reset_seconds() override { active_->reset_seconds(); }
  std::string name() const override { return active_->name(); }
  std::string device() const override { return active_->device(); }
  Precision precision() const override { return active_->precision(); }
  int threads() const override { return active_->threads(); }

 protected:
  Backend* active_;
};

/// Runs on `reference`. While comparing, every stage also runs on `other`, from the same input and with what
/// it is to write filled with NaN, and what comes out is compared.
class ComparingBackend final : public ForwardingBackend {
 public:
  ComparingBackend(Backend& reference, Backend& other) : ForwardingBackend(reference), other_(other) {}

  void compare_from_now_on(bool on) { comparing_ = on; }
  /// Compares only `stage` from now on, and keeps what the two backends then have in `fields`.
  void watch(Stage stage, FieldSet fields) {
    watched_ = stage;
    watched_fields_ = fields;
  }
  /// Watched fields, as they were when the stage was compared last.
  const std::vector<WatchedField>& watched() const { return watched_values_; }
  /// Differences of a stage found so far; without values where it was never compared.
  const Difference& difference(Stage stage) const { return found_[static_cast<uint32_t>(stage)]; }

  void allocate(FieldSet fields, const Sizes& sizes) override;
  void resize_list(uint64_t entries) override;
  void configure(const Params& params, const Needs& needs) override;
  void run(Stage stage) override;

 private:
  bool compares(Stage stage) const;
  void give_input(Stage stage);
  void keep_watched();
  Difference compare_output(Stage stage) const;

  Backend& other_;
  Sizes sizes_;
  Needs needs_;
  bool comparing_ = false;
  Stage watched_ = Stage::count;  ///< count: all are compared
  FieldSet watched_fields_;
  std::vector<WatchedField> watched_values_;
  std::array<Difference, stage_count> found_;
};

/// Reads back what every stage wrote, before the next one runs: the device does one thing at a time, and
/// nothing that it should have waited for can be missing.
class SteppedBackend final : public ForwardingBackend {
 public:
  explicit SteppedBackend(Backend& backend) : ForwardingBackend(backend) {}

  void allocate(FieldSet fields, const Sizes& sizes) override;
  void resize_list(uint64_t entries) override;
  void configure(const Params& params, const Needs& needs) override;
  void run(Stage stage) override;

 private:
  Sizes sizes_;
  Needs needs_;
};

/// Runs each step on `before` up to the stage `split` and with it, and on `after` from there to the step's
/// end.
class SplitBackend final : public ForwardingBackend {
 public:
  SplitBackend(Backend& before, Backend& after, Stage split)
      : ForwardingBackend(before), before_(before), after_(after), split_(split) {}

  void allocate(FieldSet fields, const Sizes& sizes) override;
  void resize_list(uint64_t entries) override;
  void configure(const Params& params, const Needs& needs) override;
  void run(Stage stage) override;

 private:
  void hand_over(Backend& to);

  Backend &before_, &after_;
  Stage split_;
  FieldSet fields_;
  Sizes sizes_;
};

}  // namespace sluice
