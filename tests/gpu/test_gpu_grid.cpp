// The grid on the GPU: prefix sums of any length, every particle in the cell that cell_of names, by id within
// it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/scene/random.hpp"
#include "tests/support/gpu.hpp"
#include "tests/support/search.hpp"

namespace sluice::test {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float huge = std::numeric_limits<float>::max();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

std::vector<uint32_t> shuffled_ids(uint32_t n, uint64_t seed) {
  std::vector<uint32_t> ids(n);
  std::iota(ids.begin(), ids.end(), 0u);
  Random random(seed);
  for (size_t i = n; i > 1; --i)
    std::swap(ids[i - 1], ids[static_cast<size_t>(random.uniform() * static_cast<double>(i))]);
  return ids;
}

/// The cells of these positions, as cell_of gives them in float.
std::vector<uint32_t> cells_of(const Params& params, const std::vector<Vec2>& positions) {
  std::vector<uint32_t> cells;
  for (const Vec2 x : positions) cells.push_back(cell_of(params.to<float>(), glm::vec2(x)));
  return cells;
}

/// C and L hold every particle once, in its cell, by id; id and x follow them.
void expect_sorted(const Scene& scene, const std::vector<Vec2>& positions, const std::vector<uint32_t>& ids) {
  GpuSearch search(scene, positions, ids, 16);
  search.grid();
  const auto cells = cells_of(search.params, positions);
  std::vector<uint32_t> order(positions.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, {}, [&](uint32_t i) { return std::pair(cells[i], ids[i]); });
  EXPECT_EQ(search.integers(Field::L), order);

  std::vector<uint32_t> C(search.sizes.cells + 1), id;
  std::vector<float> x;
  for (const uint32_t cell : cells) ++C[cell + 1];
  std::partial_sum(C.begin(), C.end(), C.begin());
  EXPECT_EQ(search.integers(Field::C), C);
  for (const uint32_t i : order) {
    id.push_back(ids[i]);
    x.insert(x.end(), {static_cast<float>(positions[i].x), static_cast<float>(positions[i].y)});
  }
  EXPECT_EQ(search.integers(Field::id), id);
  EXPECT_EQ(search.reals(Field::x), std::vector<double>(x.begin(), x.end()));
}

class PrefixSum : public testing::TestWithParam<uint32_t> {};

TEST_P(PrefixSum, IsThatOfTheStandardLibraryAtAwkwardLengths) {
  Gpu gpu({.group_size = GetParam()});
  for (const uint64_t length : {1u,
                                2u,
                                15u,
                                16u,
                                17u,
                                63u,
                                64u,
                                65u,
                                1023u,
                                1024u,
                                1025u,
                                4095u,
                                4096u,
                                4097u,
                                31u * 31 + 1,
                                64u * 64 + 1,
                                64u * 1024u,
                                65u * 1024u,
                                65537u,
                                256u * 256 + 1,
                                64u * 4096 + 1,
                                300'007u,
                                700u * 700 + 1,
                                1024u * 1024 + 1}) {
    std::vector<uint32_t> values(length), sums(length);
    Random random(length);
    for (uint32_t& value : values) value = static_cast<uint32_t>(4 * random.uniform());
    std::partial_sum(values.begin(), values.end(), sums.begin());
    gpu.allocate({Field::C}, {.cells = length - 1});
    gpu.backend->upload(Field::C, values);
    gpu.backend->run(Stage::grid_scan);
    EXPECT_EQ(gpu.integers(Field::C), sums) << length << " numbers";
  }
}

INSTANTIATE_TEST_SUITE_P(GroupSizes, PrefixSum, testing::Values(64, 128, 256));

TEST(GpuGrid, EveryParticleStandsOnceInItsCellById) {
  for (const uint32_t n : {1u, 2u, 63u, 64u, 65u, 1000u, 4321u}) {
    SCOPED_TRACE(n);
    expect_sorted(open_scene(10), random_positions(n, Vec2(0), Vec2(20), n), shuffled_ids(n, n + 1));
  }
}

TEST(GpuGrid, AllParticlesInOneCell) {
  expect_sorted(open_scene(10), random_positions(1500, Vec2(4.1), Vec2(4.3), 1), shuffled_ids(1500, 2));
  expect_sorted(open_scene(1), std::vector<Vec2>(300, Vec2(1, 1)), shuffled_ids(300, 3));
}

/// Strays, numbers that are none, and what lies on either side of every edge between two cells along one
/// axis.
std::vector<float> awkward_places(uint32_t cells, const Params& params) {
  std::vector<float> places{-infinity, -huge, -1e9f, -1e-30f, -0.0f, 1e-40f, 1e9f, huge, infinity, nan};
  for (uint32_t edge = 0; edge + 2 <= cells; ++edge) {
    const auto at = static_cast<float>(edge / params.inverse_cell);
    places.push_back(at);
    for (const float to : {-huge, huge}) {
      places.push_back(std::nextafter(at, to));
      places.push_back(std::nextafter(places.back(), to));
    }
  }
  return places;
}

std::vector<Vec2> awkward_positions(const Params& params) {
  std::vector<Vec2> positions;
  for (const float x : awkward_places(params.columns, params)) {
    for (const float y : awkward_places(params.rows, params)) positions.emplace_back(x, y);
  }
  return positions;
}

TEST(GpuGrid, StraysAndEdgesGoToTheCellsOfTheCpu) {
  const Scene scene = open_scene(7, 1.3);
  const auto positions = awkward_positions(make_params(scene, 1));
  GpuSearch search(scene, positions, {}, 16);
  search.backend->run(Stage::grid_count);
  const auto expected = cells_of(search.params, positions), found = search.integers(Field::cell);
  for (size_t i = 0; i < positions.size(); ++i)
    ASSERT_EQ(found[i], expected[i]) << "at " << positions[i].x << ", " << positions[i].y;
  EXPECT_EQ(std::set(found.begin(), found.end()).size(),
            (search.params.columns - 2) * (search.params.rows - 2))
      << "a cell has nobody";
}

TEST(GpuGrid, StraysAreSortedLikeAllOthers) {
  const auto positions = awkward_positions(make_params(open_scene(5), 1));
  std::vector<Vec2> numbers;  // NaN differs from itself
  std::ranges::copy_if(positions, std::back_inserter(numbers),
                       [](Vec2 x) { return !std::isnan(x.x) && !std::isnan(x.y); });
  expect_sorted(open_scene(5), numbers, shuffled_ids(static_cast<uint32_t>(numbers.size()), 5));
}

}  // namespace
}  // namespace sluice::test
