#include "tests/support/gpu.hpp"

#include <numeric>

#include "core/model/params.hpp"

namespace sluice::test {
namespace {

constexpr FieldSet grid_fields{Field::id_in, Field::x_in, Field::v_in, Field::cell, Field::C,
                               Field::L,     Field::id,   Field::x,    Field::v};
constexpr FieldSet list_fields{Field::list, Field::index, Field::gradient, Field::list_needed, Field::rho};

size_t numbers_in(Field field, const Sizes& sizes) {
  return sizes.of(info(field).length) * element_bytes(info(field).type, 4) / 4;
}

}  // namespace

std::vector<uint32_t> Gpu::integers(Field field) const {
  std::vector<uint32_t> values(numbers_in(field, sizes));
  backend->download(field, values);
  return values;
}

std::vector<double> Gpu::reals(Field field) const {
  std::vector<double> values(numbers_in(field, sizes));
  backend->download(field, values);
  return values;
}

GpuSearch::GpuSearch(const Scene& scene, const std::vector<Vec2>& positions, std::vector<uint32_t> ids,
                     uint64_t list_entries, const gpu::BackendOptions& options)
    : Gpu(options), params(make_params(scene, static_cast<uint32_t>(positions.size()))) {
  const uint64_t n = positions.size();
  if (ids.empty()) {
    ids.resize(n);
    std::iota(ids.begin(), ids.end(), 0u);
  }
  const uint64_t enough = (n + slice_width) * (n + slice_width) + 64;
  allocate(grid_fields | list_fields,
           {n, 0, uint64_t{params.columns} * params.rows, list_entries > 0 ? list_entries : enough});
  backend->configure(params, Needs{});
  backend->upload(Field::id_in, ids);
  std::vector<double> x;
  for (const Vec2 position : positions) x.insert(x.end(), {position.x, position.y});
  backend->upload(Field::x_in, x);
}

void GpuSearch::grid() {
  for (const Stage stage :
       {Stage::grid_count, Stage::grid_scan, Stage::grid_scatter, Stage::grid_order, Stage::reorder})
    backend->run(stage);
}

void GpuSearch::run() {
  grid();
  backend->run(Stage::neighbours);
}

uint64_t GpuSearch::entries() const {
  const std::vector<uint32_t> list = integers(Field::list);
  uint64_t sum = 0;
  for (size_t i = 1; i < list.size(); i += 2) sum += list[i];
  return sum;
}

std::vector<std::vector<uint32_t>> GpuSearch::lists() const {
  const std::vector<uint32_t> list = integers(Field::list), index = integers(Field::index);
  std::vector<std::vector<uint32_t>> result(params.n);
  for (size_t i = 0; i < result.size(); ++i) {
    for (size_t k = 0; k < list[2 * i + 1]; ++k) result[i].push_back(index.at(list[2 * i] + slice_width * k));
  }
  return result;
}

std::vector<std::set<uint32_t>> GpuSearch::neighbour_sets() const {
  const std::vector<uint32_t> id = integers(Field::id);
  const auto by_place = lists();
  std::vector<std::set<uint32_t>> sets(params.n);
  for (size_t i = 0; i < sets.size(); ++i) {
    for (const uint32_t j : by_place[i]) sets.at(id[i]).insert(id.at(j));
  }
  return sets;
}

}  // namespace sluice::test
