// All hard cases that take longer than a moment, on both backends: docs/hard_cases.md.
#include "tests/support/hard.hpp"

namespace sluice::test {

using namespace study;
namespace {

class HardCases : public testing::TestWithParam<HardRun> {};

TEST_P(HardCases, ComeOutAsExpected) { expect_as_expected(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Long, HardCases, testing::ValuesIn(hard_runs(false)),
                         [](const auto& row) { return row.param.name(); });

}  // namespace
}  // namespace sluice::test
