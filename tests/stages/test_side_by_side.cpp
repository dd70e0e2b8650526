// The lists and their gradients, and the sums over them, are those that a few loops in this file find, with
// every set of instructions; also for particles that no scene has, and where no list has an entry, for values
// that would show. And the parts that the search of cpu/simd is made of.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "cpu/kernel.hpp"
#include "cpu/simd/search.hpp"
#include "cpu/stage_functions.hpp"
#include "tests/support/search.hpp"

namespace sluice::test {
namespace {

template <class Real>
using Vec = glm::vec<2, Real>;

/// Whether two values have the same bits; of a NaN the sign may differ, which compilers are free to choose.
template <class Real>
bool is_same(Real a, Real b) {
  return std::memcmp(&a, &b, sizeof(a)) == 0 || (std::isnan(a) && std::isnan(b));
}

template <class Real>
bool is_same(Vec<Real> a, Vec<Real> b) {
  return is_same(a.x, b.x) && is_same(a.y, b.y);
}

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return std::ranges::equal(a, b, [](const T& one, const T& other) { return is_same(one, other); });
}

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

/// Particles far and near, alone, in clusters, in one place and outside the grid; lists of very different
/// lengths, and a last slice that is not full.
std::vector<Vec2> scattered() {
  std::vector<Vec2> positions = random_positions(1000, {0, 0}, {20, 40}, 1);
  append(positions, random_positions(60, {30, 30}, {30.5, 30.5}, 2));
  append(positions, random_positions(30, {-5, -5}, {50, 50}, 3));
  append(positions, std::vector<Vec2>(5, Vec2(33.25, 3.5)));
  append(positions, {Vec2(1e6, 3), Vec2(1e6, 3), Vec2(-1e9, 1e30), Vec2(std::nan(""), 1), Vec2(39.9, 39.9)});
  return positions;
}

/// Positions, so many in one cell that they are searched one by one, and some elsewhere.
std::vector<Vec2> crowded() {
  std::vector<Vec2> positions = random_positions(700, {8, 8}, {10, 10}, 4);
  append(positions, random_positions(200, {0, 0}, {40, 40}, 5));
  return positions;
}

std::vector<std::vector<Vec2>> cases() {
  return {scattered(), crowded(), random_positions(15, {0, 0}, {3, 3}, 6),
          random_positions(16, {0, 0}, {3, 3}, 7), random_positions(37, {0, 0}, {3, 3}, 8)};
}

/// Calls a stage as it is with a set of instructions.
template <class Real>
void run(Stage stage, cpu::State<Real>& state, cpu::Instructions instructions) {
  cpu::functions_with<Real>(instructions).all[static_cast<uint32_t>(stage)](state);
}

/// Neighbours of i by looking at everybody.
template <class Real>
std::vector<uint32_t> neighbours_of(const cpu::State<Real>& state, uint32_t i) {
  std::vector<uint32_t> found;
  for (uint32_t j = 0; j < state.params.n; ++j) {
    const Vec<Real> x_ij = state.x[i] - state.x[j];
    if (glm::dot(x_ij, x_ij) < state.params.support_squared && j != i) found.push_back(j);
  }
  return found;
}

template <class Real>
void expect_plain_lists(const std::vector<Vec2>& positions, int threads, cpu::Instructions instructions) {
  auto state = searched<Real>(open_scene(20), positions, threads);
  std::ranges::fill(state.index, ~0u);
  run(Stage::neighbours, state, instructions);
  run(Stage::density, state, instructions);
  for (uint32_t i = 0; i < state.params.n; ++i) {
    std::vector<uint32_t> index;
    std::vector<Vec<Real>> gradients, expected;
    for_each_neighbour(state, i, [&](uint32_t j, Vec<Real> dW) {
      index.push_back(j);
      gradients.push_back(dW);
      const Vec<Real> x_ij = state.x[i] - state.x[j];
      const Real r = glm::length(x_ij);
      const Vec<Real> parting = state.params.parting_gradient;
      expected.push_back(r >= state.params.coincidence ? cpu::kernel_gradient(state.params, x_ij, r)
                         : state.id[i] > state.id[j]   ? parting
                                                       : -parting);
    });
    ASSERT_EQ(index, neighbours_of(state, i)) << i;
    ASSERT_TRUE(same_bits(gradients, expected)) << i;
  }
}

TEST(SideBySide, ListsAreThoseOfAPlainSearch) {
  for (const cpu::Instructions instructions : cpu::available_instructions()) {
    SCOPED_TRACE(name_of(instructions));
    for (const auto& positions : cases()) {
      for (const int threads : {1, 2, 3}) {
        expect_plain_lists<float>(positions, threads, instructions);
        expect_plain_lists<double>(positions, threads, instructions);
      }
    }
  }
}

template <class Real>
void expect_found_in_any_ranges() {
  const auto state = searched<Real>(open_scene(20), scattered());
  const uint32_t n = state.params.n;
  for (uint32_t i = 0; i < n; ++i) {
    // Ranges of any length and place, the last of all included; only the middle one has i.
    const std::array<glm::uvec2, 3> rows{{{i / 2, std::min(i / 2 + i % 40, i)},
                                          {i - i % 7, std::min(i + 1 + i % 20, n)},
                                          {std::max(n - 1 - i % 35, i + 1), n}}};
    std::vector<uint32_t> expected;
    const auto all = neighbours_of(state, i);
    for (const glm::uvec2 row : rows) {
      std::copy_if(all.begin(), all.end(), std::back_inserter(expected),
                   [&](uint32_t j) { return row.x <= j && j < row.y; });
    }
    cpu::Cell<Real> cell;
    cpu::Neighbours neighbours;
    cpu::set_candidates(state.x, rows, cell);
    ASSERT_FALSE(cell.crowded);
    const uint32_t count = cpu::find(cell, i, state.x[i], state.params.support_squared, neighbours);
    const std::vector<uint32_t> found(neighbours.begin(), neighbours.begin() + count);
    ASSERT_EQ(found, expected) << i;
  }
}

TEST(SideBySide, FoundAreThoseOfTheRangesAndNoOthers) {
  expect_found_in_any_ranges<float>();
  expect_found_in_any_ranges<double>();
}

/// Searched, with values for the stages to work on; where no list has an entry, the worst there can be.
template <class Real>
cpu::State<Real> prepared(const std::vector<Vec2>& positions) {
  auto state = searched<Real>(open_scene(20), positions, 2);
  const uint32_t n = state.params.n;
  state.params.nu = Real(0.3);
  state.params.xsph = Real(0.7);
  const auto values = random_positions(3 * n, {0.5, -1}, {1.5, 1}, 9);
  for (uint32_t i = 0; i < n; ++i) {
    state.rho[i] = static_cast<Real>(values[3 * i].x);
    state.q.push_back(static_cast<Real>(values[3 * i].y));
    state.v[i] = Vec<Real>(values[3 * i + 1]);
    state.a_n.push_back(Vec<Real>(values[3 * i + 2]));
  }
  state.a_p.resize(n);
  // Sums that are lost if anything is added to them for a neighbour they do not have.
  state.q[n / 2] = std::numeric_limits<Real>::infinity();
  std::vector<uint32_t> index(state.index.size(), ~0u);
  std::vector<Real> gradient(state.gradient.size(), std::numeric_limits<Real>::quiet_NaN());
  for (const glm::uvec2 list : state.list) {
    for (uint32_t k = 0; k < list.y; ++k) {
      const uint64_t entry = list.x + uint64_t{slice_width} * k, block = 2 * entry - list.x % slice_width;
      index[entry] = state.index[entry];
      for (const uint64_t at : {block, block + slice_width}) gradient[at] = state.gradient[at];
    }
  }
  state.index = index;
  state.gradient = gradient;
  return state;
}

template <class Real>
void expect_plain_sums(const std::vector<Vec2>& positions, cpu::Instructions instructions) {
  auto state = prepared<Real>(positions);
  const auto& params = state.params;
  std::vector<Real> rho;
  std::vector<Vec<Real>> a_p, a_n, smoothed;
  for (uint32_t i = 0; i < params.n; ++i) {
    Real W = cpu::kernel(params, Real(0));
    Vec<Real> pressure{}, viscous{}, differences{};
    for_each_neighbour(state, i, [&](uint32_t j, Vec<Real> dW) {
      const Vec<Real> x_ij = state.x[i] - state.x[j];
      W += cpu::kernel(params, glm::length(x_ij));
      pressure += (state.q[i] + state.q[j]) * dW;
      const Real approach = glm::dot(state.v[i] - state.v[j], x_ij);
      differences += (cpu::kernel(params, glm::length(x_ij)) / state.rho[j]) * (state.v[i] - state.v[j]);
      viscous += (approach / ((glm::dot(x_ij, x_ij) + params.viscosity_floor) * state.rho[j])) * dW;
    });
    rho.push_back(params.m * W);
    a_p.push_back(-(params.m * pressure));
    a_n.push_back(state.a_n[i] + (Real(2) * params.nu) * (params.m * viscous));
    smoothed.push_back(a_n.back() - params.xsph * differences);
  }
  run(Stage::viscosity, state, instructions);
  EXPECT_TRUE(same_bits(state.a_n, a_n));
  run(Stage::xsph, state, instructions);
  EXPECT_TRUE(same_bits(state.a_n, smoothed));
  run(Stage::pressure_acceleration, state, instructions);
  run(Stage::density, state, instructions);
  EXPECT_TRUE(same_bits(state.a_p, a_p));
  EXPECT_TRUE(same_bits(state.rho, rho));
}

/// The sums of the linear system, from velocities, densities and accelerations as they are.
template <class Real>
void expect_plain_system(const std::vector<Vec2>& positions, cpu::Instructions instructions) {
  auto state = prepared<Real>(positions);
  auto& params = state.params;
  params.dt = Real(0.1);
  params.source_weight = 1;
  state.needs.linear_system = true;
  state.v_star = state.v;
  state.a_p = state.a_n;
  for (auto* field : {&state.A_ii, &state.s, &state.Ap}) field->resize(params.n);
  std::vector<Real> A_ii, s, Ap;
  for (uint32_t i = 0; i < params.n; ++i) {
    Vec<Real> sum{};
    Real squares{}, divergence{}, change{};
    for_each_neighbour(state, i, [&](uint32_t j, Vec<Real> dW) {
      sum += dW;
      squares += glm::dot(dW, dW);
      divergence += glm::dot(state.v_star[i] - state.v_star[j], dW);
      change += glm::dot(state.a_p[i] - state.a_p[j], dW);
    });
    sum = params.m * sum;
    A_ii.push_back(-(params.dt * params.dt) * (glm::dot(sum, sum) + params.m * params.m * squares));
    s.push_back(params.source_weight * (params.rho0 - state.rho[i]) - params.dt * (params.m * divergence));
    Ap.push_back((params.dt * params.dt) * (params.m * change));
  }
  run(Stage::diagonal, state, instructions);
  run(Stage::source, state, instructions);
  run(Stage::pressure_operator, state, instructions);
  EXPECT_TRUE(same_bits(state.A_ii, A_ii));
  EXPECT_TRUE(same_bits(state.s, s));
  EXPECT_TRUE(same_bits(state.Ap, Ap));
}

TEST(SideBySide, SumsAreThoseOfOneParticleAtATime) {
  for (const cpu::Instructions instructions : cpu::available_instructions()) {
    SCOPED_TRACE(name_of(instructions));
    for (const auto& positions : cases()) {
      expect_plain_sums<float>(positions, instructions);
      expect_plain_sums<double>(positions, instructions);
      expect_plain_system<float>(positions, instructions);
      expect_plain_system<double>(positions, instructions);
    }
  }
}

template <class Real>
void expect_the_same_lane_by_lane() {
  const auto positions = random_positions(1000, {0, -1}, {1e6, 1}, 12);
  for (size_t i = 0; i + 1 < positions.size(); i += 2) {
    cpu::Vector<Real> values, others;
    for (uint32_t lane = 0; lane < cpu::lane_count<Real>; ++lane) {
      values[lane] = static_cast<Real>(positions[i + lane % 2].x / (1 + lane));
      others[lane] = static_cast<Real>(positions[i + lane % 2].y);
    }
    const auto a = cpu::square_root(values), b = cpu::by_lane::square_root(values);
    EXPECT_EQ(std::memcmp(&a, &b, sizeof a), 0);
    EXPECT_EQ(cpu::bits_below(others, Real(0)), cpu::by_lane::bits_below(others, Real(0)));
  }
}

TEST(SideBySide, RootsAndMasksAreTheSameLaneByLane) {
  expect_the_same_lane_by_lane<float>();
  expect_the_same_lane_by_lane<double>();
}

}  // namespace
}  // namespace sluice::test
