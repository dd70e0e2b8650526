// Orders, limits and verdicts of the study `validate`.
#include <gtest/gtest.h>

#include <cmath>

#include "studies/validation.hpp"
#include "studies/validation_page.hpp"

namespace sluice::test {

using namespace study;
namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(ErrorCurve, OrderIsTheSlopeOverTheSpacing) {
  EXPECT_NEAR((ErrorCurve{{{20, 0.04}, {40, 0.02}, {80, 0.01}}}).order(), 1, 1e-12);
  EXPECT_NEAR((ErrorCurve{{{20, 0.04}, {80, 0.0025}}}).order(), 2, 1e-12);
  EXPECT_TRUE(std::isnan((ErrorCurve{{{20, 0.04}}}).order()));
  EXPECT_TRUE(std::isnan((ErrorCurve{{{20, 0.04}, {80, 0}}}).order()));
}

std::string validation_page(const ErrorCurves& curves, std::vector<std::string>& faults) {
  return page_of(validation_tables(curves, faults));
}

/// Two methods, of which B is better at N = 40 and worse at the others.
ErrorCurves two_methods(double b_at_40) {
  return {{{"oscillating_drop", "period", "A", "double"}, {{{20, 0.001}, {40, 0.004}, {80, 0.0001}}}},
          {{"oscillating_drop", "period", "A", "float"}, {{{20, 0.001}, {40, 0.0041}, {80, 0.0001}}}},
          {{"oscillating_drop", "period", "B", "double"}, {{{20, 0.01}, {40, b_at_40}, {80, 0.0007}}}},
          {{"oscillating_drop", "period", "B", "gpu"}, {{{20, 0.013}}}}};
}

// The limit of the period is 0.3 % at N = 40, its aim 0.05 % at N = 80.
TEST(ValidationPage, JudgesTheMethodThatIsBestAt40) {
  std::vector<std::string> faults;
  const std::string page = validation_page(two_methods(0.002), faults);
  EXPECT_TRUE(has(
      page, "| oscillating_drop | period | B | 1 % | 0.2 % | 0.07 % | 1.9 | 0.3 % | pass | 0.05 % | FAIL |"))
      << page;
  EXPECT_TRUE(faults.empty());
}

TEST(ValidationPage, ALimitThatIsNotMetIsAFault) {
  std::vector<std::string> faults;
  const std::string page = validation_page(two_methods(0.0035), faults);
  EXPECT_TRUE(has(page, "| B | 1 % | 0.35 % | 0.07 % | 1.9 | 0.3 % | FAIL |")) << page;
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0], "oscillating_drop: period of B is off by 0.35 % at N = 40, expected at most 0.3 %");
}

// A method that is valid at N = 20 only is not the best one of those that were run at N = 40.
TEST(ValidationPage, ARunThatBecameInvalidIsAFaultWhenNoneIsBetter) {
  std::vector<std::string> faults;
  const ErrorKey a{"oscillating_drop", "period", "A", "double"},
      b{"oscillating_drop", "period", "B", "double"};
  EXPECT_TRUE(has(
      validation_page({{a, {{{20, 0.001}, {40, invalid_error}}}}, {b, {{{20, 0.01}, {40, 0.002}}}}}, faults),
      "| period | B | 1 % | 0.2 % |"));
  EXPECT_TRUE(faults.empty());
  const std::string page = validation_page({{a, {{{20, 0.001}, {40, invalid_error}}}}}, faults);
  EXPECT_TRUE(has(page, "| A | 0.1 % | invalid |  |  | 0.3 % | FAIL |")) << page;
  EXPECT_EQ(faults.size(), 1u);
}

TEST(ValidationPage, ExactCasesAreExactWithEveryMethod) {
  std::vector<std::string> faults;
  validation_page({{{"free_fall", "momentum", "IISPH", "double"}, {{{40, 1e-15}}}},
                   {{"free_fall", "momentum", "SSPH", "double"}, {{{40, 1e-6}}}}},
                  faults);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_TRUE(has(faults[0], "free_fall: momentum of SSPH")) << faults[0];
}

TEST(ValidationPage, ShowsWhatRoundingChanges) {
  std::vector<std::string> faults;
  const std::string page = validation_page(two_methods(0.002), faults);
  EXPECT_TRUE(
      has(page, "| oscillating_drop | period | A | 0.1 % | 0.4 % | 0.01 % | 1.7 | 0 % | 0.01 % | 0 % |  |"))
      << page;
  EXPECT_TRUE(has(page, "| oscillating_drop | period | B | 1 % | 0.2 % | 0.07 % | 1.9 |  |  |  | 0.3 % |"))
      << page;
}

// Of ten errors of 1 %, nine change by 0, 1, ... 8 % of themselves and one by half; one that is rounding does
// not count.
TEST(ValidationPage, SaysHowMuchErrorsChange) {
  ErrorCurves curves;
  for (int i = 0; i < 10; ++i) {
    const std::string method = std::to_string(i);
    curves[{"dam_break", "height", method, "double"}].error[40] = 0.01;
    curves[{"dam_break", "height", method, "float"}].error[40] = 0.01 * (i < 9 ? 1 - 0.01 * i : 1.5);
  }
  curves[{"free_fall", "momentum", "IISPH", "double"}].error[40] = 1e-15;
  curves[{"free_fall", "momentum", "IISPH", "float"}].error[40] = 1e-6;
  std::vector<std::string> faults;
  EXPECT_TRUE(
      has(validation_page(curves, faults),
          "- N = 40, in float instead of double: half of 10 errors change by less than 5 % of themselves, "
          "nine of ten by less than 50 %\n"))
      << validation_page(curves, faults);
}

TEST(ValidationPage, OfRunsAt20AloneTheBestIsShown) {
  std::vector<std::string> faults;
  const ErrorCurves curves{{{"oscillating_drop", "period", "A", "double"}, {{{20, 0.02}}}},
                           {{"oscillating_drop", "period", "B", "double"}, {{{20, 0.01}}}}};
  EXPECT_TRUE(has(validation_page(curves, faults), "| period | B | 1 % |  |  |  | 0.3 % | not run |"));
}

TEST(ValidationPage, NamesWhatWasNotRun) {
  std::vector<std::string> faults;
  EXPECT_TRUE(
      has(validation_page({}, faults), "| oscillating_drop | period |  |  |  |  |  | 0.3 % | not run |"));
  EXPECT_TRUE(faults.empty());
}

}  // namespace
}  // namespace sluice::test
