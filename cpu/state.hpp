// What the CPU stages work on: constants, fields, and the two ways of walking over them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/fields.hpp"
#include "core/params.hpp"
#include "core/stages.hpp"

namespace sluice::cpu {

template <class Real, Type type>
struct ElementOf;
template <class Real>
struct ElementOf<Real, Type::real> {
  using element = Real;
};
template <class Real>
struct ElementOf<Real, Type::vec2> {
  using element = glm::vec<2, Real>;
};
template <class Real>
struct ElementOf<Real, Type::vec4> {
  using element = glm::vec<4, Real>;
};
template <class Real>
struct ElementOf<Real, Type::uint> {
  using element = uint32_t;
};
template <class Real>
struct ElementOf<Real, Type::uvec2> {
  using element = glm::uvec2;
};

template <class Real>
struct State {
  using Vec = glm::vec<2, Real>;

  ParamsOf<Real> params;
  Needs needs;
  Sizes sizes;
  int threads = 1;  ///< the same for every stage: changing the size of a team costs more than a small stage

#define FIELD(name, type, length, unit, meaning) \
  std::vector<typename ElementOf<Real, Type::type>::element> name;
  SLUICE_FIELDS(FIELD)
#undef FIELD
};

/// What the pressure force has at the boundary in place of q_i + q_j: q_i + p_i/rho0^2 where samples mirror
/// the pressure.
template <class Real>
Real wall_pressure_term(const ParamsOf<Real>& params, Real q, Real rho) {
  return q + q * (rho * rho) * params.wall_pressure;
}

/// Calls f(i) for all i < n on `threads` threads. Who runs which i does not matter: f writes only what
/// belongs to i.
template <class F>
void for_each_index(uint64_t n, int threads, F&& f) {
#pragma omp parallel for num_threads(threads) schedule(static)
  for (int64_t i = 0; i < static_cast<int64_t>(n); ++i) f(static_cast<uint32_t>(i));
}

/// Calls f(chunk, first, last) for all chunks of `n` particles; the chunk's are first to last - 1.
template <class F>
void for_each_chunk(uint32_t n, int threads, F&& f) {
  const auto call = [&](uint32_t chunk) {
    f(chunk, chunk * chunk_width, std::min((chunk + 1) * chunk_width, n));
  };
  for_each_index((uint64_t{n} + chunk_width - 1) / chunk_width, threads, call);
}

/// Calls f(first, last) for the three ranges of places in L, one per row of cells, that hold all particles in
/// reach of a position in `cell`; `C` gives the first place of each cell.
template <class F>
void for_each_row(const std::vector<uint32_t>& C, uint32_t columns, uint32_t cell, F&& f) {
  for (const uint32_t middle : {cell - columns, cell, cell + columns}) f(C[middle - 1], C[middle + 2]);
}

}  // namespace sluice::cpu
