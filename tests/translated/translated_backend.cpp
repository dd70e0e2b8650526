// Fields as words, and the walk over passes.
#include "tests/translated/translated_backend.hpp"

#include <algorithm>
#include <bit>
#include <stdexcept>

#include "gpu/passes.hpp"

namespace sluice::test {
namespace {

constexpr uint32_t group_size = 64;

uint64_t words_of(Field field, const Sizes& sizes) {
  return sizes.of(info(field).length) * element_bytes(info(field).type, 4) / 4;
}

template <class F>
void for_each_field(FieldSet fields, F&& f) {
  for (uint32_t i = 0; i < field_count; ++i) {
    if (fields.has(static_cast<Field>(i))) f(static_cast<Field>(i));
  }
}

glsl::Memory& scratch() { return glsl::memory_of(gpu::scratch_block); }
glsl::Memory& sweep_groups() { return glsl::memory_of(gpu::sweep_groups_block); }

uint64_t groups_of(const gpu::Pass& pass) { return (pass.count + pass.per_group - 1) / pass.per_group; }

void require_size(const glsl::Memory& memory, size_t words) {
  if (memory.size() != words) throw std::logic_error("a field of another length");
}

}  // namespace

glsl::Memory& TranslatedBackend::words_of_field(Field field) const {
  return glsl::memory_of(gpu::block_name(field));
}

void TranslatedBackend::make_field(Field field) {
  words_of_field(field).resize(words_of(field, sizes_), true);
}

void TranslatedBackend::allocate(FieldSet fields, const Sizes& sizes) {
  fields_ = fields;
  sizes_ = sizes;
  for (uint32_t i = 0; i < field_count; ++i) words_of_field(static_cast<Field>(i)).resize(0, false);
  for_each_field(fields, [&](Field field) { make_field(field); });
  scratch().resize(gpu::scratch_size(sizes), false);
  sweep_groups().resize(3 * static_cast<uint64_t>(gpu::SweepGroups::count), true);
}

void TranslatedBackend::resize_list(uint64_t entries) {
  sizes_.list = entries;
  for (const Field field : {Field::index, Field::gradient}) make_field(field);
}

void TranslatedBackend::configure(const Params& params, const Needs& needs) {
  glsl::params = params.to<float>();
  needs_ = needs;
}

const glsl::Unit& TranslatedBackend::unit(Stage stage, uint32_t pass) const {
  const auto with = [&](std::string_view fault) {
    return std::ranges::find_if(glsl::units(), [&, fault](const glsl::Unit& one) {
      return one.stage == info(stage).name && one.pass == pass && one.fault == fault;
    });
  };
  const auto faulty = with(fault_), sound = with("");
  if (faulty != glsl::units().end()) return *faulty;
  if (sound == glsl::units().end()) throw std::logic_error("a pass that was not translated");
  return *sound;
}

void TranslatedBackend::run(Stage stage) { run(stage, false); }

void TranslatedBackend::run(Stage stage, bool in_sweep) {
  const auto kind = static_cast<uint64_t>(gpu::sweep_groups_of(stage));
  const auto left_in_sweep = [&] { return uint64_t{sweep_groups().words()[3 * kind]}; };
  if (in_sweep && left_in_sweep() == 0) return;
  scratch().forget();
  const FieldSet reads = reads_of(stage, needs_);
  for_each_field(writes_of(stage, needs_), [&](Field field) {
    if (!reads.has(field)) words_of_field(field).forget();
  });
  for (const gpu::Pass& pass : gpu::passes_of(stage, sizes_, group_size)) {
    const gpu::PassConstants constants = gpu::constants_of(pass, sizes_);
#define CONSTANT(name, meaning) glsl::name = constants.name;
    SLUICE_PASS_CONSTANTS(CONSTANT)
#undef CONSTANT
    const glsl::Unit& one = unit(stage, pass.number);
    for (const auto& [name, value] : one.needs)
      *value = needs_.*std::ranges::find(need_table, name, &NeedInfo::name)->need;
    glsl::dispatch(one, in_sweep ? left_in_sweep() : groups_of(pass), group_size, order_);
  }
}

void TranslatedBackend::sweep(const std::vector<Stage>& stages, uint32_t times) {
  std::vector<uint32_t>& groups = sweep_groups().words();
  std::ranges::fill(groups, 0);
  for (const Stage stage : stages) {
    uint32_t& most = groups[3 * static_cast<uint64_t>(gpu::sweep_groups_of(stage))];
    for (const gpu::Pass& pass : gpu::passes_of(stage, sizes_, group_size))
      most = std::max(most, static_cast<uint32_t>(groups_of(pass)));
  }
  for (uint32_t k = 0; k < times; ++k) {
    for (const Stage stage : stages) run(stage, true);
  }
}

void TranslatedBackend::swap(Field a, Field b) { words_of_field(a).swap(words_of_field(b)); }

void TranslatedBackend::upload(Field field, std::span<const double> values) {
  require_size(words_of_field(field), values.size());
  std::ranges::transform(values, words_of_field(field).words().begin(),
                         [](double value) { return std::bit_cast<uint32_t>(static_cast<float>(value)); });
  words_of_field(field).mark_written();
}

void TranslatedBackend::upload(Field field, std::span<const uint32_t> values) {
  require_size(words_of_field(field), values.size());
  std::ranges::copy(values, words_of_field(field).words().begin());
  words_of_field(field).mark_written();
}

void TranslatedBackend::download(Field field, std::span<double> values) const {
  require_size(words_of_field(field), values.size());
  std::ranges::transform(words_of_field(field).words(), values.begin(),
                         [](uint32_t word) { return static_cast<double>(std::bit_cast<float>(word)); });
}

void TranslatedBackend::download(Field field, std::span<uint32_t> values) const {
  require_size(words_of_field(field), values.size());
  std::ranges::copy(words_of_field(field).words(), values.begin());
}

}  // namespace sluice::test
