// The neighbour lists of the GPU: those of all-pairs distances wherever the particles are; what happens when
// the list is too short, and when more particles crowd around one than a shader can loop over.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "core/output/output_file.hpp"
#include "core/scene/random.hpp"
#include "core/solver/simulator.hpp"
#include "sluice/error.hpp"
#include "sluice/load.hpp"
#include "tests/support/gpu.hpp"
#include "tests/support/message_of.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/search.hpp"

namespace sluice::test {
namespace {

/// Entries that these lists take: each slice as many as its longest, times its particles.
uint32_t needed_by(const std::vector<std::vector<uint32_t>>& lists) {
  size_t sum = 0;
  for (size_t first = 0; first < lists.size(); first += slice_width) {
    size_t longest = 0;
    for (size_t i = first; i < std::min(first + slice_width, lists.size()); ++i)
      longest = std::max(longest, lists[i].size());
    sum += slice_width * longest;
  }
  return static_cast<uint32_t>(sum);
}

void expect_same_neighbours(const Scene& scene, const std::vector<Vec2>& positions, uint64_t at_least,
                            const gpu::BackendOptions& options = {}) {
  const auto expected = all_pairs<float>(scene, positions);
  EXPECT_GE(total(expected), at_least) << "the case checks nothing";
  GpuSearch search(scene, positions, {}, 0, options);
  search.run();
  const auto found = search.neighbour_sets();
  ASSERT_EQ(found.size(), expected.size());
  for (size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i], expected[i]) << "particle " << i;
  EXPECT_EQ(search.entries(), total(expected)) << "an entry stands twice";
  const auto lists = search.lists();
  for (const auto& list : lists) EXPECT_TRUE(std::ranges::is_sorted(list));
  EXPECT_EQ(search.list_needed(), needed_by(lists));
}

TEST(GpuNeighbours, RandomCloud) {
  for (const uint32_t group_size : {64u, 256u}) {
    const gpu::BackendOptions options{.group_size = group_size};
    expect_same_neighbours(open_scene(10), random_positions(600, {0, 0}, {20, 20}, 1), 600 * 10, options);
    expect_same_neighbours(open_scene(7, 1.5), random_positions(400, {0, 0}, {21, 21}, 2), 400 * 10, options);
  }
}

TEST(GpuNeighbours, CornersAndEmptyCells) {
  std::vector<Vec2> positions;
  for (const Vec2 corner : {Vec2(0, 0), Vec2(20, 0), Vec2(0, 20), Vec2(20, 20)}) {
    for (const Vec2 offset : random_positions(8, {-0.5, -0.5}, {0.5, 0.5}, 3))
      positions.push_back(corner + offset);
  }
  expect_same_neighbours(open_scene(10), positions, 4 * 8 * 7);
}

TEST(GpuNeighbours, AllInOneCell) {
  expect_same_neighbours(open_scene(10), random_positions(300, {4.1, 4.1}, {4.3, 4.3}, 4), 300 * 299);
}

TEST(GpuNeighbours, Coincident) {
  std::vector<Vec2> positions = random_positions(100, {0, 0}, {20, 20}, 5);
  positions.insert(positions.end(), positions.begin(), positions.end());
  positions.insert(positions.end(), 40, Vec2(7, 7));
  expect_same_neighbours(open_scene(10), positions, 40 * 39 + 200);
}

// Positions on multiples of the cell edge, and a hair to either side of them, where rounding decides the
// cell.
TEST(GpuNeighbours, OnCellEdges) {
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

TEST(GpuNeighbours, ManyCells) {
  Scene scene = open_scene(2000);
  scene.domain_max.y = 20;
  expect_same_neighbours(scene, random_positions(800, {3980, 0}, {4000, 20}, 5), 800 * 10);
}

TEST(GpuNeighbours, StraysOutsideTheGrid) {
  auto positions = random_positions(200, {-15, -15}, {35, 35}, 6);
  for (const Vec2 far : {Vec2(1e6, 3), Vec2(-1e6, -1e6), Vec2(3, 1e30)}) {
    positions.push_back(far);
    positions.push_back(far);
  }
  expect_same_neighbours(open_scene(10), positions, 150);
}

TEST(GpuNeighbours, AwkwardNumbersOfParticles) {
  for (const uint32_t n : {1u, 2u, 15u, 16u, 17u, 63u, 64u, 65u, 129u}) {
    SCOPED_TRACE(n);
    expect_same_neighbours(open_scene(10), random_positions(n, {0, 0}, {4, 4}, n), n > 2 ? n : 0);
  }
}

TEST(GpuNeighbours, AShortListSaysWhatItNeedsAndIsEmptyUntilItHasIt) {
  const Scene scene = open_scene(10);
  const auto positions = random_positions(501, {0, 0}, {10, 10}, 9);
  GpuSearch enough(scene, positions);
  enough.run();
  const uint32_t needed = enough.list_needed();
  for (const uint64_t entries : {uint64_t{slice_width}, uint64_t{needed} / 2, uint64_t{needed} - 1}) {
    GpuSearch search(scene, positions, {}, entries);
    search.run();
    EXPECT_EQ(search.list_needed(), needed) << entries;
    EXPECT_EQ(search.entries(), 0u) << entries;
    search.resize_list(needed);
    search.backend->run(Stage::neighbours);
    EXPECT_EQ(search.list_needed(), needed) << entries;
    EXPECT_EQ(search.neighbour_sets(), enough.neighbour_sets()) << entries;
  }
}

// Software devices read fields as images, until the list has outgrown the largest image.
TEST(GpuNeighbours, AListThatOutgrowsTheLargestImageIsReadAllTheSame) {
  const Scene scene = open_scene(10);
  const auto positions = random_positions(500, {0, 0}, {10, 10}, 10);
  GpuSearch enough(scene, positions);
  enough.run();
  enough.backend->run(Stage::density);
  GpuSearch search(scene, positions, {}, slice_width, {.most_texels = 1100});
  search.run();
  search.resize_list(search.list_needed());
  EXPECT_GT(search.sizes.list, 1100u);
  search.backend->run(Stage::neighbours);
  search.backend->run(Stage::density);
  EXPECT_EQ(search.reals(Field::rho), enough.reals(Field::rho));
}

/// Particle 0 stands in a cell that claims to hold all `n` particles; the last one is its only neighbour, and
/// all others are far away, where cells claim to be empty.
struct Crowd : GpuSearch {
  explicit Crowd(uint32_t n) : GpuSearch(open_scene(10), positions(n), {}, 1024) {
    const uint32_t crowded = cell_of(params, positions(2)[0]);
    std::vector<uint32_t> C(sizes.cells + 1, 0);
    std::fill(C.begin() + crowded + 1, C.end(), n);
    std::vector<double> x;
    for (const Vec2 position : positions(n)) x.insert(x.end(), {position.x, position.y});
    backend->upload(Field::C, C);
    backend->upload(Field::x, x);
    backend->run(Stage::neighbours);
  }
  static std::vector<Vec2> positions(uint32_t n) {
    std::vector<Vec2> all(n, Vec2(15, 15));
    all.front() = Vec2(3, 3);
    all.back() = Vec2(3.1, 3);
    return all;
  }
};

TEST(GpuNeighbours, AsManyCandidatesAsAShaderMayLookThrough) {
  const Crowd crowd(most_rounds);
  EXPECT_EQ(crowd.lists()[0], std::vector<uint32_t>{most_rounds - 1});
  EXPECT_LE(crowd.list_needed(), crowd.sizes.list);
}

TEST(GpuNeighbours, OneCandidateMoreIsBeyondBounds) {
  const Crowd crowd(most_rounds + 1);
  EXPECT_EQ(crowd.list_needed(), list_beyond_bounds);
  EXPECT_EQ(crowd.entries(), 0u);
}

// With a shader that may look through 300 candidates, since 65,000 particles in a few cells take long.
TEST(GpuNeighbours, ARunWithACrowdAroundAParticleIsRefused) {
  const TemporaryFolder folder;
  std::string shader = read_file(std::filesystem::path(SLUICE_SOURCE_DIR) / "shaders" / "neighbours.comp");
  ASSERT_NE(shader.find("most_rounds"), std::string::npos);
  write_file(folder / "neighbours.comp", "#define most_rounds 300u\n" + shader);
  const Gpu gpu({}, gpu::ShaderLibrary(folder.path));

  const Scene scene = load_scene("breaking_dam");
  Samples samples = sample(scene);
  for (size_t i = 0; i < 300; ++i) samples.fluid[i] = Vec2(184, 184);
  const std::string message =
      message_of<InputError>([&] { const Simulator simulator(scene, samples, *gpu.backend); });
  EXPECT_NE(message.find("too many particles in one place"), std::string::npos) << message;
}

}  // namespace
}  // namespace sluice::test
