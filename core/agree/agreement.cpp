// Transfers between backends, and the comparison of a stage.
#include "core/agree/agreement.hpp"

#include <algorithm>
#include <limits>

namespace sluice {
namespace {

constexpr FieldSet list_fields{Field::list, Field::index, Field::gradient};

/// Values for all of `field`, none of which a stage could have meant.
FieldValues poison(Field field, const Sizes& sizes) {
  const uint64_t count = sizes.of(info(field).length) * element_bytes(info(field).type, 4) / 4;
  FieldValues values;
  if (is_integer(field))
    values.integers.assign(count, 0xdeadbeef);
  else
    values.reals.assign(count, std::numeric_limits<double>::quiet_NaN());
  return values;
}

/// What the lists hold of one of their fields, wherever their slices stand.
Difference compare_lists(const NeighbourLists& a, const NeighbourLists& b, Field field) {
  if (field == Field::list) return compare(a.lengths, b.lengths, field);
  if (field == Field::index) return compare(a.index, b.index, field);
  return compare(a.gradient, b.gradient, field);
}

/// The field's values for people: those of the list as the particles have them, wherever the slices stand.
FieldValues shown_values(const Backend& backend, Field field, const Sizes& sizes) {
  if (!list_fields.has(field)) return values_of(backend, field, sizes);
  const NeighbourLists lists = lists_of(backend, sizes);
  if (field == Field::gradient) return {lists.gradient, {}};
  return {{}, field == Field::list ? lists.lengths : lists.index};
}

/// Sorts L within each cell: until grid_order has run, the order there is left to chance.
void sort_within_cells(std::vector<uint32_t>& L, const Backend& backend, const Sizes& sizes) {
  const std::vector<uint32_t> C = values_of(backend, Field::C, sizes).integers;
  for (uint64_t cell = 0; cell + 1 < C.size(); ++cell) {
    const uint64_t first = C[cell], last = C[cell + 1];
    if (first < last && last <= L.size())
      std::sort(L.begin() + static_cast<int64_t>(first), L.begin() + static_cast<int64_t>(last));
  }
}

template <class F>
void for_each_field(FieldSet set, F&& f) {
  for (uint32_t i = 0; i < field_count; ++i) {
    if (set.has(static_cast<Field>(i))) f(static_cast<Field>(i));
  }
}

}  // namespace

FieldValues values_of(const Backend& backend, Field field, const Sizes& sizes) {
  FieldValues values = poison(field, sizes);
  if (is_integer(field))
    backend.download(field, values.integers);
  else
    backend.download(field, values.reals);
  return values;
}

void put_values(Backend& backend, Field field, const FieldValues& values) {
  if (is_integer(field))
    backend.upload(field, values.integers);
  else
    backend.upload(field, values.reals);
}

NeighbourLists lists_of(const Backend& backend, const Sizes& sizes) {
  const std::vector<uint32_t> list = values_of(backend, Field::list, sizes).integers;
  const std::vector<uint32_t> index = values_of(backend, Field::index, sizes).integers;
  const std::vector<double> gradient = values_of(backend, Field::gradient, sizes).reals;
  NeighbourLists lists;
  for (uint64_t i = 0; i < sizes.fluid; ++i) {
    lists.lengths.push_back(list[2 * i + 1]);
    for (uint64_t k = 0; k < list[2 * i + 1]; ++k) {
      const uint64_t entry = list[2 * i] + slice_width * k;
      if (entry >= index.size()) return lists;  // a list that is wrong already shows by its length
      const uint64_t block = 2 * entry - entry % slice_width;
      lists.index.push_back(index[entry]);
      lists.gradient.push_back(gradient[block]);
      lists.gradient.push_back(gradient[block + slice_width]);
    }
  }
  return lists;
}

void ComparingBackend::allocate(FieldSet fields, const Sizes& sizes) {
  sizes_ = sizes;
  active_->allocate(fields, sizes);
  other_.allocate(fields, sizes);
}

void ComparingBackend::resize_list(uint64_t entries) {
  sizes_.list = entries;
  active_->resize_list(entries);
  other_.resize_list(entries);
}

void ComparingBackend::configure(const Params& params, const Needs& needs) {
  needs_ = needs;
  active_->configure(params, needs);
  other_.configure(params, needs);
}

void ComparingBackend::run(Stage stage) {
  const bool compare = compares(stage);
  if (compare) give_input(stage);
  active_->run(stage);
  if (!compare) return;
  other_.run(stage);
  found_[static_cast<uint32_t>(stage)].add(compare_output(stage));
  if (stage == watched_) keep_watched();
}

bool ComparingBackend::compares(Stage stage) const {
  return (comparing_ || runs_once(stage)) && (watched_ == Stage::count || watched_ == stage);
}

void ComparingBackend::keep_watched() {
  watched_values_.clear();
  for_each_field(watched_fields_, [&](Field field) {
    watched_values_.push_back(
        {field, shown_values(*active_, field, sizes_), shown_values(other_, field, sizes_)});
  });
}

void ComparingBackend::give_input(Stage stage) {
  const FieldSet reads = reads_of(stage, needs_);
  for_each_field(reads | writes_of(stage, needs_), [&](Field field) {
    put_values(other_, field, reads.has(field) ? values_of(*active_, field, sizes_) : poison(field, sizes_));
  });
}

/// What the stage writes has to agree, and what it only reads has to be as it was.
Difference ComparingBackend::compare_output(Stage stage) const {
  Difference result;
  const FieldSet writes = writes_of(stage, needs_);
  for_each_field(reads_of(stage, needs_) | writes, [&](Field field) {
    if (writes.has(field) && list_fields.has(field)) {
      result.add(compare_lists(lists_of(*active_, sizes_), lists_of(other_, sizes_), field));
      return;
    }
    // How many entries the list needs depends on how a backend shares it out among its threads.
    if (field == Field::list_needed) return;
    FieldValues a = values_of(*active_, field, sizes_), b = values_of(other_, field, sizes_);
    if (stage == Stage::grid_scatter && field == Field::L) {
      sort_within_cells(a.integers, *active_, sizes_);
      sort_within_cells(b.integers, other_, sizes_);
    }
    Difference found =
        is_integer(field) ? compare(a.integers, b.integers, field) : compare(a.reals, b.reals, field);
    if (!writes.has(field) && found.equal == found.values) return;  // input counts only when it was changed
    result.add(found);
  });
  return result;
}

void SteppedBackend::allocate(FieldSet fields, const Sizes& sizes) {
  sizes_ = sizes;
  active_->allocate(fields, sizes);
}

void SteppedBackend::resize_list(uint64_t entries) {
  sizes_.list = entries;
  active_->resize_list(entries);
}

void SteppedBackend::configure(const Params& params, const Needs& needs) {
  needs_ = needs;
  active_->configure(params, needs);
}

void SteppedBackend::run(Stage stage) {
  active_->run(stage);
  for_each_field(writes_of(stage, needs_), [&](Field field) { values_of(*active_, field, sizes_); });
}

void SplitBackend::allocate(FieldSet fields, const Sizes& sizes) {
  active_ = &before_;
  fields_ = fields;
  sizes_ = sizes;
  before_.allocate(fields, sizes);
  after_.allocate(fields, sizes);
}

void SplitBackend::resize_list(uint64_t entries) {
  sizes_.list = entries;
  before_.resize_list(entries);
  after_.resize_list(entries);
}

void SplitBackend::configure(const Params& params, const Needs& needs) {
  before_.configure(params, needs);
  after_.configure(params, needs);
}

/// A step begins with the grid, whatever its plan, or again with the neighbours when their list was too
/// short.
void SplitBackend::run(Stage stage) {
  const bool begins = stage == Stage::grid_count || stage == Stage::neighbours;
  if (begins && split_ >= stage) hand_over(before_);
  active_->run(stage);
  if (stage == split_) hand_over(after_);
}

void SplitBackend::hand_over(Backend& to) {
  if (active_ == &to) return;
  for_each_field(fields_, [&](Field field) { put_values(to, field, values_of(*active_, field, sizes_)); });
  active_ = &to;
}

}  // namespace sluice
