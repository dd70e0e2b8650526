// A backend that runs the translated shaders as the GPU backend runs the shaders: the same passes, the same
// scratch, and sweeps whose groups the stop test takes away. In float, and in an order of its own.
#pragma once

#include <array>
#include <map>

#include "core/solver/backend.hpp"
#include "tests/translated/glsl.hpp"

namespace sluice::test {

class TranslatedBackend final : public Backend {
 public:
  /// With `fault`, the stage that it was seeded into has it.
  explicit TranslatedBackend(glsl::Order order, std::string_view fault = {}) : order_(order), fault_(fault) {}

  void allocate(FieldSet fields, const Sizes& sizes) override;
  void resize_list(uint64_t entries) override;
  void configure(const Params& params, const Needs& needs) override;
  void run(Stage stage) override;
  void sweep(const std::vector<Stage>& stages, uint32_t times) override;
  void swap(Field a, Field b) override;
  void upload(Field field, std::span<const double> values) override;
  void upload(Field field, std::span<const uint32_t> values) override;
  void download(Field field, std::span<double> values) const override;
  void download(Field field, std::span<uint32_t> values) const override;
  double seconds(Stage) const override { return 0; }
  void reset_seconds() override {}
  std::string name() const override { return "translated"; }
  std::string device() const override { return "shaders translated to C++"; }
  Precision precision() const override { return Precision::single_; }
  int threads() const override { return 1; }

 private:
  glsl::Memory& words_of_field(Field field) const;
  void make_field(Field field);
  void run(Stage stage, bool in_sweep);
  const glsl::Unit& unit(Stage stage, uint32_t pass) const;

  glsl::Order order_;
  std::string fault_;
  FieldSet fields_;
  Sizes sizes_;
  Needs needs_;
};

}  // namespace sluice::test
