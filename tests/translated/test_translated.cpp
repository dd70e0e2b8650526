// All stages' shaders, translated to C++, in runs of every shipped scene: bit for bit the CPU's in whatever
// order invocations run, without a race, an access out of bounds or a read of what nobody wrote. No driver is
// asked. And that these checks find faults.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/support/simulation.hpp"
#include "tests/translated/faults.hpp"
#include "tests/translated/translated_backend.hpp"

namespace sluice::test {
namespace {

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

/// What is found in so many steps of the scene; "other bits" among it.
std::string findings_in(const Scene& scene, glsl::Order order, std::string_view fault, int steps) {
  glsl::findings.clear();
  Simulation cpu(scene, Precision::single_);
  TranslatedBackend translated(order, fault);
  Simulator simulator(cpu.scene, cpu.samples, translated);
  for (int step = 0; step < steps; ++step) {
    const StepReport a = cpu.simulator->step(), b = simulator.step();
    if (a.iterations != b.iterations || !same_bits(cpu.simulator->snapshot(), simulator.snapshot())) {
      glsl::findings.push_back(fmt::format("other bits in step {}", step + 1));
      break;
    }
    if (!glsl::findings.empty()) break;
  }
  return joined(glsl::findings);
}

class Translated : public testing::TestWithParam<ShippedRun> {};

TEST_P(Translated, RunsAreTheCpusInEveryOrderAndNothingIsFound) {
  const Scene scene = GetParam().load({"fluid.jitter=0.05", "fluid.relax=1"});
  for (const glsl::Order order : {glsl::Order::forward, glsl::Order::backward, glsl::Order::shuffled})
    EXPECT_EQ(findings_in(scene, order, "", 3), "") << "order " << static_cast<int>(order);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Translated, testing::ValuesIn(shipped_runs()),
                         [](const auto& test) { return test.param.name(); });

TEST(TranslatedStages, AllOfThemAreThere) {
  std::set<std::string_view> stages;
  for (const glsl::Unit& unit : glsl::units()) stages.insert(unit.stage);
  EXPECT_EQ(stages.size(), stage_count);
}

TEST(TranslatedStages, EverySeededFaultIsFound) {
  const Scene scene = shipped("breaking_dam", {"fluid.jitter=0.05"});
  for (const SeededFault& fault : seeded_faults) {
    std::string found;
    for (const glsl::Order order : {glsl::Order::forward, glsl::Order::backward})
      found += findings_in(scene, order, fault.name, 2);
    const std::string_view expected = fault.finding.empty() ? "other bits" : fault.finding;
    EXPECT_NE(found.find(expected), std::string::npos) << fault.name << ":\n" << found;
  }
}

}  // namespace
}  // namespace sluice::test
