#include "tests/support/search.hpp"

#include <numeric>

#include "core/scene/random.hpp"

namespace sluice::test {

std::vector<Vec2> random_positions(uint32_t n, Vec2 min, Vec2 max, uint64_t seed) {
  Random random(seed);
  std::vector<Vec2> positions;
  for (uint32_t i = 0; i < n; ++i) {
    const double x = random.uniform(), y = random.uniform();
    positions.push_back(min + Vec2(x, y) * (max - min));
  }
  return positions;
}

uint64_t total(const std::vector<std::set<uint32_t>>& sets) {
  uint64_t sum = 0;
  for (const auto& set : sets) sum += set.size();
  return sum;
}

Scene open_scene(double cells, double smoothing) {
  Scene scene;
  scene.spacing = 1;
  scene.smoothing = smoothing;
  scene.rest_density = 1;
  scene.domain_max = Vec2(2 * smoothing * cells);
  return scene;
}

template <class Real>
cpu::State<Real> searched(const Scene& scene, const std::vector<Vec2>& positions, int threads,
                          uint64_t list_entries) {
  const auto n = static_cast<uint32_t>(positions.size());
  cpu::State<Real> state;
  state.params = make_params(scene, n).to<Real>();
  state.threads = threads;
  state.sizes = {n, 0, uint64_t{state.params.columns} * state.params.rows,
                 list_entries > 0 ? list_entries : uint64_t{n + 16} * (n + 16) + 64};
  state.id_in.resize(n);
  std::iota(state.id_in.begin(), state.id_in.end(), 0u);
  for (const Vec2 x : positions) state.x_in.emplace_back(x);
  state.v_in.resize(n);
  state.p_in.resize(n);
  state.cell.resize(n);
  state.L.resize(n);
  state.C.resize(state.sizes.of(Length::cells));
  state.id.resize(n);
  state.x.resize(n);
  state.v.resize(n);
  state.p.resize(n);
  state.list.resize(n);
  state.index.resize(state.sizes.of(Length::list));
  state.gradient.resize(state.sizes.of(Length::gradients));
  state.list_needed.resize(1);
  state.rho.resize(n);
  cpu::grid_count(state);
  cpu::grid_scan(state);
  cpu::grid_scatter(state);
  cpu::grid_order(state);
  cpu::reorder(state);
  cpu::neighbours(state);
  cpu::density(state);
  return state;
}

template <class Real>
std::vector<std::set<uint32_t>> neighbour_sets(const cpu::State<Real>& state) {
  std::vector<std::set<uint32_t>> sets(state.params.n);
  for (uint32_t i = 0; i < state.params.n; ++i) {
    for_each_neighbour(state, i, [&](uint32_t j, auto) { sets[state.id[i]].insert(state.id[j]); });
  }
  return sets;
}

template <class Real>
std::vector<std::set<uint32_t>> all_pairs(const Scene& scene, const std::vector<Vec2>& positions) {
  const auto params = make_params(scene, 1).to<Real>();
  std::vector<std::set<uint32_t>> sets(positions.size());
  for (uint32_t i = 0; i < positions.size(); ++i) {
    for (uint32_t j = 0; j < positions.size(); ++j) {
      const glm::vec<2, Real> x_ij = glm::vec<2, Real>(positions[i]) - glm::vec<2, Real>(positions[j]);
      if (i != j && glm::dot(x_ij, x_ij) < params.support_squared) sets[i].insert(j);
    }
  }
  return sets;
}

template cpu::State<float> searched(const Scene&, const std::vector<Vec2>&, int, uint64_t);
template cpu::State<double> searched(const Scene&, const std::vector<Vec2>&, int, uint64_t);
template std::vector<std::set<uint32_t>> neighbour_sets(const cpu::State<float>&);
template std::vector<std::set<uint32_t>> neighbour_sets(const cpu::State<double>&);
template std::vector<std::set<uint32_t>> all_pairs<float>(const Scene&, const std::vector<Vec2>&);
template std::vector<std::set<uint32_t>> all_pairs<double>(const Scene&, const std::vector<Vec2>&);

}  // namespace sluice::test
