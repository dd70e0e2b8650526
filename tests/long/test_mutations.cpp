// The claims of test_mutated_scenes.cpp over 100,000 scene files and as many overrides, and over 10,000
// recordings and as many checkpoints. `scripts/test --long` runs these under the address and
// undefined-behaviour sanitizers too.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/mutated_files.hpp"
#include "tests/support/mutated_scenes.hpp"

namespace sluice::test {
namespace {

constexpr uint64_t scenes_each = 12'500, files_each = 1250;

/// One of eight shares; the fast suite has the seeds below a million.
class Mutations : public testing::TestWithParam<uint64_t> {};

TEST_P(Mutations, ScenesAreLoadedOrRefused) {
  expect_claims_of_scenes({1'000'000 + GetParam() * scenes_each, scenes_each});
}

TEST_P(Mutations, OverridesAreTakenOrRefused) {
  expect_claims_of_overrides({1'000'000 + GetParam() * scenes_each, scenes_each});
}

TEST_P(Mutations, RecordingsAreLoadedOrRefused) {
  expect_claims_of_files(recording_kind(), {1'000'000 + GetParam() * files_each, files_each});
}

TEST_P(Mutations, CheckpointsAreLoadedOrRefused) {
  expect_claims_of_files(checkpoint_kind(), {1'000'000 + GetParam() * files_each, files_each});
}

INSTANTIATE_TEST_SUITE_P(Shares, Mutations, testing::Range<uint64_t>(0, 8));

}  // namespace
}  // namespace sluice::test
