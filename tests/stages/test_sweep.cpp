// Two stages over the neighbour list in one pass: the second is nowhere before the first is done as far as
// neighbours reach, every particle is done once, and parts begin with slices.
#include <gtest/gtest.h>

#include <atomic>
#include <memory>

#include "cpu/simd/sweep.hpp"

namespace sluice::test {
namespace {

/// What the stages have found. Stages are plain functions, so that this cannot be theirs.
struct Record {
  size_t n, reach;
  std::unique_ptr<std::atomic<int>[]> first, second;
  std::atomic<int> too_early = 0, crooked = 0;
};
Record* record = nullptr;

void first(cpu::State<float>&, cpu::Part part) {
  if (part.first % slice_width != 0) ++record->crooked;
  for (size_t i = part.first; i < part.last; ++i) ++record->first[i];
}

void second(cpu::State<float>&, cpu::Part part) {
  if (part.first % slice_width != 0) ++record->crooked;
  const size_t from = part.first - std::min(part.first, record->reach);
  const size_t to = std::min(record->n, part.last + record->reach);
  for (size_t i = from; i < to; ++i) {
    if (record->first[i] == 0) ++record->too_early;
  }
  for (size_t i = part.first; i < part.last; ++i) ++record->second[i];
}

TEST(Sweep, TheSecondStageFollowsTheFirstOutOfReach) {
  for (const size_t n : {1u, 15u, 16u, 17u, 64u, 1000u, 4096u, 10'007u}) {
    for (const size_t reach : {size_t{0}, size_t{1}, size_t{50}, size_t{700}, size_t{6000}, ~size_t{0} / 4}) {
      for (const int threads : {1, 2, 3, 7}) {
        Record found{n, reach, std::make_unique<std::atomic<int>[]>(n),
                     std::make_unique<std::atomic<int>[]>(n)};
        record = &found;
        cpu::State<float> state;
        state.params.n = static_cast<uint32_t>(n);
        state.threads = threads;
        state.reach = reach;
        const auto [seconds, share] = cpu::run_both<float>(state, first, second);
        EXPECT_GE(seconds, 0);
        EXPECT_TRUE(share >= 0 && share <= 1) << share;
        EXPECT_EQ(found.too_early, 0) << n << ", reach " << reach << ", threads " << threads;
        EXPECT_EQ(found.crooked, 0);
        for (size_t i = 0; i < n; ++i) ASSERT_TRUE(found.first[i] == 1 && found.second[i] == 1) << i;
      }
    }
  }
  record = nullptr;
}

}  // namespace
}  // namespace sluice::test
