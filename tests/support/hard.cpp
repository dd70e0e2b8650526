#include "tests/support/hard.hpp"

#include <cmath>

#include "core/agree/agree.hpp"
#include "cpu/backend.hpp"
#include "gpu/backend.hpp"
#include "gpu/context.hpp"
#include "studies/hard_table.hpp"

namespace sluice::test {

using namespace study;
namespace {

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

void expect_finite(const Snapshot& state) {
  for (size_t i = 0; i < state.x.size(); ++i) {
    for (const double value :
         {state.x[i].x, state.x[i].y, state.v[i].x, state.v[i].y, state.density[i], state.pressure[i]})
      ASSERT_TRUE(std::isfinite(value)) << "particle " << i;
  }
}

CaseResult run_on_cpu(const HardCase& hard) {
  return run_case(hard, *cpu::make_backend(Precision::single_, 2));
}

void expect_equal(const HardCase& hard, CaseResult found, const CaseResult& expected) {
  EXPECT_EQ(found.end.step, expected.end.step);
  EXPECT_TRUE(same_bits(found.end, expected.end));
  found.backend = expected.backend;
  EXPECT_EQ(hard_row(hard, found), hard_row(hard, expected));
}

}  // namespace

std::vector<HardRun> hard_runs(bool quick) {
  std::vector<HardRun> runs;
  for (HardCase& hard : hard_cases()) {
    if (hard.quick != quick) continue;
    runs.push_back({hard, false});
    runs.push_back({std::move(hard), true});
  }
  return runs;
}

void expect_as_expected(const HardRun& run) {
  if (!run.on_gpu) {
    const CaseResult result = run_on_cpu(run.hard);
    EXPECT_EQ(joined(faults(run.hard, result)), "");
    return expect_finite(result.end);
  }
  const gpu::Context context;
  const CaseResult result = run_case(run.hard, *gpu::make_backend(context));
  EXPECT_EQ(joined(faults(run.hard, result)), "");
  expect_finite(result.end);
  if (context.software()) expect_equal(run.hard, result, run_on_cpu(run.hard));
}

}  // namespace sluice::test
