// The grid search finds the neighbours that all-pairs distances find: as sets, wherever the particles are.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/scene/random.hpp"
#include "tests/support/search.hpp"

namespace sluice::test {
namespace {

template <class Real>
void expect_same_neighbours(const Scene& scene, const std::vector<Vec2>& positions, uint64_t at_least) {
  const auto expected = all_pairs<Real>(scene, positions);
  const auto state = searched<Real>(scene, positions);
  const auto found = neighbour_sets(state);
  ASSERT_EQ(found.size(), expected.size());
  EXPECT_GE(total(expected), at_least) << "the case checks nothing";
  for (size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i], expected[i]) << "particle " << i;
  uint64_t entries = 0;
  for (const glm::uvec2 list : state.list) entries += list.y;
  EXPECT_EQ(entries, total(expected)) << "an entry stands twice";
}

void expect_same_neighbours(const Scene& scene, const std::vector<Vec2>& positions, uint64_t at_least) {
  expect_same_neighbours<float>(scene, positions, at_least);
  expect_same_neighbours<double>(scene, positions, at_least);
}

TEST(Neighbours, RandomCloud) {
  expect_same_neighbours(open_scene(10), random_positions(600, {0, 0}, {20, 20}, 1), 600 * 10);
  expect_same_neighbours(open_scene(7, 1.5), random_positions(400, {0, 0}, {21, 21}, 2), 400 * 10);
}

TEST(Neighbours, CornersAndEmptyCells) {
  std::vector<Vec2> positions;
  for (const Vec2 corner : {Vec2(0, 0), Vec2(20, 0), Vec2(0, 20), Vec2(20, 20)}) {
    for (const Vec2 offset : random_positions(8, {-0.5, -0.5}, {0.5, 0.5}, 3))
      positions.push_back(corner + offset);
  }
  expect_same_neighbours(open_scene(10), positions, 4 * 8 * 7);
}

TEST(Neighbours, AllInOneCell) {
  expect_same_neighbours(open_scene(10), random_positions(300, {4.1, 4.1}, {4.3, 4.3}, 4), 300 * 299);
}

// Positions on multiples of the cell edge, and a hair to either side of them, where rounding decides the
// cell.
TEST(Neighbours, OnCellEdges) {
  std::vector<Vec2> positions;
  for (int j = 0; j <= 10; ++j) {
    for (int i = 0; i <= 10; ++i) {
      const double hair = 1e-7 * (i - 5);
      positions.push_back({2 * i + hair, 2 * j - hair});
      positions.push_back({2 * i + 0.7, 2 * j - hair});
    }
  }
  expect_same_neighbours(open_scene(10), positions, 100);
}

TEST(Neighbours, ManyCellsInFloat) {
  Scene scene = open_scene(2000);
  scene.domain_max.y = 20;
  expect_same_neighbours<float>(scene, random_positions(800, {3980, 0}, {4000, 20}, 5), 800 * 10);
}

// Outside the grid the cell is clamped: neighbours stay neighbours, however far the strays are.
TEST(Neighbours, StraysOutsideTheGrid) {
  auto positions = random_positions(200, {-15, -15}, {35, 35}, 6);
  for (const Vec2 far : {Vec2(1e6, 3), Vec2(-1e6, -1e6), Vec2(3, 1e30)}) {
    positions.push_back(far);
    positions.push_back(far);
  }
  expect_same_neighbours(open_scene(10), positions, 150);
}

TEST(Neighbours, AwkwardNumbersOfParticles) {
  for (const uint32_t n : {1u, 2u, 15u, 16u, 17u, 63u, 64u, 65u, 129u}) {
    SCOPED_TRACE(n);
    expect_same_neighbours(open_scene(10), random_positions(n, {0, 0}, {4, 4}, n), n > 2 ? n : 0);
  }
}

TEST(Neighbours, ListIsAscendingAndTheSameForAnyNumberOfThreads) {
  const auto positions = random_positions(2000, {0, 0}, {20, 20}, 8);
  const auto one = searched<double>(open_scene(10), positions, 1);
  for (const int threads : {2, 3, 4}) {
    const auto many = searched<double>(open_scene(10), positions, threads);
    ASSERT_EQ(one.id, many.id);
    for (uint32_t i = 0; i < one.params.n; ++i) {
      std::vector<uint32_t> a, b;
      std::vector<glm::dvec2> dW_a, dW_b;
      for_each_neighbour(one, i, [&](uint32_t j, glm::dvec2 dW) { a.push_back(j), dW_a.push_back(dW); });
      for_each_neighbour(many, i, [&](uint32_t j, glm::dvec2 dW) { b.push_back(j), dW_b.push_back(dW); });
      ASSERT_TRUE(std::is_sorted(a.begin(), a.end()));
      ASSERT_EQ(a, b);
      ASSERT_EQ(dW_a, dW_b);
    }
  }
}

// A list that is too short is not written beyond its end, and says how long it has to be.
TEST(Neighbours, ShortListSaysWhatItNeeds) {
  const auto positions = random_positions(500, {0, 0}, {10, 10}, 9);
  for (const int threads : {1, 2, 4}) {
    const auto enough = searched<double>(open_scene(10), positions, threads);
    const uint32_t needed = enough.list_needed[0];
    const auto exact = searched<double>(open_scene(10), positions, threads, needed + 16u * 4u);
    EXPECT_LE(exact.list_needed[0], needed + 16u * 4u);
    EXPECT_EQ(neighbour_sets(exact), neighbour_sets(enough));
    const auto short_list = searched<double>(open_scene(10), positions, threads, needed / 2 / 16 * 16);
    EXPECT_GT(short_list.list_needed[0], needed / 2);
  }
}

}  // namespace
}  // namespace sluice::test
