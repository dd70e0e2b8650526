// Two stages over the neighbour list in one pass, so that the list is read from memory once and not twice:
// every thread walks through its part block by block, and the second stage follows the first at the distance
// at which all neighbours have the first one's results. What neighbours beyond the part have to do with is
// done at the end, when all threads are there. While the second stage computes, it fetches the list of the
// block that the first one comes to next.
#pragma once

#include <omp.h>

#include <algorithm>
#include <array>
#include <chrono>

#include "cpu/simd/part.hpp"

namespace sluice::cpu {

/// Runs both; returns how many seconds that took, and what share of them was the first one's.
template <class Real>
std::array<double, 2> run_both(State<Real>& state, PartFunction<Real> first, PartFunction<Real> second) {
  using Clock = std::chrono::steady_clock;
  constexpr size_t block_size = 1024;
  constexpr uint64_t second_level = 1 << 20;  // bytes of a list that stays there from sweep to sweep
  const size_t n = state.params.n, reach = state.reach;
  const uint64_t bytes_per_thread =
      state.sizes.list * (sizeof(uint32_t) + 2 * sizeof(Real)) / static_cast<uint64_t>(state.threads);
  const bool fetches = bytes_per_thread > second_level;
  double seconds_of_first = 0, seconds_of_second = 0;
  const auto start = Clock::now();
#pragma omp parallel num_threads(state.threads) reduction(+ : seconds_of_first, seconds_of_second)
  {
    auto last_time = Clock::now();
    const auto run = [&](PartFunction<Real> stage, Part part, double& seconds) {
      if (part.first < part.last) stage(state, part);
      const auto now = Clock::now();
      seconds += std::chrono::duration<double>(now - last_time).count();
      last_time = now;
    };
    const Range own = share_of(n, omp_get_thread_num(), omp_get_num_threads());
    const auto whole_slices = [](size_t particles) { return particles / slice_width * slice_width; };
    const size_t begin =
        own.first == 0 ? 0 : std::min(own.last, whole_slices(own.first + reach + slice_width - 1));
    size_t done = begin;
    for (size_t from = own.first; from < own.last; from += block_size) {
      const size_t to = std::min(from + block_size, own.last);
      run(first, {{from, to}}, seconds_of_first);
      const size_t ready = to == n ? n : to > reach ? whole_slices(to - reach) : 0;
      run(second, {{done, ready}, fetches && to < own.last ? to - done : 0}, seconds_of_second);
      done = std::max(done, ready);
    }
#pragma omp barrier
    last_time = Clock::now();
    run(second, {{own.first, begin}}, seconds_of_second);
    run(second, {{done, own.last}}, seconds_of_second);
  }
  const double total = std::chrono::duration<double>(Clock::now() - start).count();
  const double both = seconds_of_first + seconds_of_second;
  return {total, both > 0 ? seconds_of_first / both : 0.5};
}

}  // namespace sluice::cpu
