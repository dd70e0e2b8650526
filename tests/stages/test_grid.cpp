// The compact grid: C and L hold every particle once, in its cell, by id within the cell.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "core/scene/random.hpp"
#include "tests/support/search.hpp"

namespace sluice::test {
namespace {

std::vector<Vec2> shuffled_lattice(uint32_t side) {
  std::vector<Vec2> positions;
  for (uint32_t i = 0; i < side * side; ++i) positions.push_back({0.5 + i % side, 0.5 + i / side});
  Random random(3);
  for (size_t i = positions.size(); i > 1; --i) {
    std::swap(positions[i - 1], positions[static_cast<size_t>(random.uniform() * static_cast<double>(i))]);
  }
  return positions;
}

TEST(Grid, EveryParticleStandsOnceInItsCellById) {
  const auto positions = shuffled_lattice(20);
  for (const int threads : {1, 2, 4}) {
    const auto state = searched<double>(open_scene(10), positions, threads);
    EXPECT_EQ(state.C.front(), 0u);
    EXPECT_EQ(state.C.back(), positions.size());
    std::vector<uint32_t> seen = state.L;
    std::sort(seen.begin(), seen.end());
    for (uint32_t i = 0; i < seen.size(); ++i) ASSERT_EQ(seen[i], i);
    for (uint32_t cell = 0; cell < state.sizes.cells; ++cell) {
      for (uint32_t place = state.C[cell]; place < state.C[cell + 1]; ++place) {
        ASSERT_EQ(state.cell[state.L[place]], cell);
        ASSERT_EQ(state.x[place], positions[state.id[place]]);
        if (place > state.C[cell]) {
          ASSERT_LT(state.id[place - 1], state.id[place]);
        }
      }
    }
  }
}

TEST(Grid, PaddingCellsAreEmptyWhereverParticlesGo) {
  const auto params = make_params(open_scene(10), 1).to<float>();
  const float huge = std::numeric_limits<float>::max(), infinity = std::numeric_limits<float>::infinity();
  for (const float x : {-infinity, -huge, -1.0f, 0.0f, 7.0f, 20.0f, 1e9f, huge, infinity,
                        std::numeric_limits<float>::quiet_NaN()}) {
    for (const float y : {-huge, 3.0f, huge}) {
      const uint32_t cell = cell_of(params, glm::vec2(x, y));
      EXPECT_GE(cell % params.columns, 1u);
      EXPECT_LE(cell % params.columns, params.columns - 2);
      EXPECT_GE(cell / params.columns, 1u);
      EXPECT_LE(cell / params.columns, params.rows - 2);
    }
  }
}

TEST(Grid, CellsGrowWithPosition) {
  const auto params = make_params(open_scene(50), 1).to<float>();
  uint32_t last = 0;
  for (float x = -10; x < 120; x += 0.01f) {
    const uint32_t column = cell_of(params, glm::vec2(x, 1)) % params.columns;
    EXPECT_GE(column, last);
    last = column;
  }
  EXPECT_EQ(last, params.columns - 2);
}

}  // namespace
}  // namespace sluice::test
