// The page about a GPU hides neither a failing test suite nor a GPU that disagrees with the CPU.
#include <gtest/gtest.h>

#include <fstream>

#include "bench/findings.hpp"
#include "tests/support/run_program.hpp"

namespace sluice::test {
namespace {

using bench::Finding;

class BenchFindings : public ::testing::Test {
 protected:
  std::filesystem::path written(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }

  TemporaryFolder folder_;
};

bool says(const Finding& finding, const std::string& text) {
  return finding.markdown.find(text) != std::string::npos;
}

std::string agreement(bool pass, const std::string& max_ulp) {
  const std::string verdict = pass ? "true" : "false";
  return R"({"format": 1, "scene": "breaking_dam", "device": "a GPU", "steps": 200, "stages": [
    {"name": "density", "max_abs": 0, "max_ulp": 0, "equal_share": 1, "tolerance": 0, "pass": true},
    {"name": "source", "max_abs": 1e-7, "max_ulp": )" +
         max_ulp + R"(, "equal_share": 0.999999, "tolerance": 0, "pass": )" + verdict + R"(}],
    "run": {"equal": )" +
         verdict + R"(, "first_difference_step": 17, "max_dx_over_h": 0.25, "iterations_equal": true},
    "gpu_with_itself": {"equal": )" +
         verdict + R"(},
    "pass": )" +
         verdict + "}";
}

TEST_F(BenchFindings, TestsThatPassAreGood) {
  const Finding finding =
      bench::read_test_log(written("log", "1/2 Test\n\n100% tests passed, 0 tests failed out of 2\n"));
  EXPECT_TRUE(finding.good);
  EXPECT_TRUE(says(finding, "0 tests failed out of 2"));
}

TEST_F(BenchFindings, FailedTestsAreNamed) {
  const Finding finding = bench::read_test_log(written(
      "log",
      "50% tests passed, 1 tests failed out of 2\n\nTotal Test time (real) =   1 sec\n\n"
      "The following tests FAILED:\n\t  2 - Density.IsRight (Failed)                   fast\nErrors\n"));
  EXPECT_FALSE(finding.good);
  EXPECT_TRUE(says(finding, "**50% tests passed, 1 tests failed out of 2**"));
  EXPECT_TRUE(says(finding, "- 2 - Density.IsRight (Failed)"));
  EXPECT_FALSE(says(finding, "Errors"));
}

TEST_F(BenchFindings, ALogWithoutAVerdictIsNotGood) {
  EXPECT_FALSE(bench::read_test_log(written("log", "1/2 Test\n")).good);
  const Finding finding = bench::read_test_log(folder_ / "missing");
  EXPECT_FALSE(finding.good);
  EXPECT_TRUE(says(finding, "did not come to its end"));
}

TEST_F(BenchFindings, AgreementIsGivenByRunAndStage) {
  const Finding finding = bench::read_agreement({written("dam.json", agreement(true, "3"))});
  EXPECT_TRUE(finding.good);
  EXPECT_TRUE(says(finding, "| dam | 200 | equal bit for bit | 0.25 | yes | equal | agrees |"));
  EXPECT_TRUE(says(finding, "| density | 0 ulp, 100 % |"));
  EXPECT_TRUE(says(finding, "| source | 3 ulp, 99.999 % |")) << "a share must not be rounded up to all";
}

TEST_F(BenchFindings, OneDisagreementSpoilsAll) {
  const Finding finding = bench::read_agreement(
      {written("bad.json", agreement(false, "null")), written("good.json", agreement(true, "0"))});
  EXPECT_FALSE(finding.good);
  EXPECT_TRUE(
      says(finding, "| bad | 200 | differs from step 17 on | 0.25 | yes | **DIFFERS** | **DISAGREES** |"));
  EXPECT_TRUE(says(finding, "| source | **not finite ulp, 99.999 %** | 0 ulp, 99.999 % |"));
}

TEST_F(BenchFindings, AFileThatCannotBeReadIsNotGood) {
  const auto good = written("good.json", agreement(true, "0"));
  for (const auto& path :
       {folder_ / "missing.json", written("empty.json", ""), written("other.json", "{}")}) {
    const Finding finding = bench::read_agreement({good, path});
    EXPECT_FALSE(finding.good);
    EXPECT_TRUE(says(finding, "**" + path.stem().string() + ": no result"));
    EXPECT_TRUE(says(finding, "| good | 200 |")) << "the others are shown";
  }
}

}  // namespace
}  // namespace sluice::test
