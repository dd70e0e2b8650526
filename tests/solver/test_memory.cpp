// A scene that does not fit is refused before anything is allocated, with what it would need.
#include <gtest/gtest.h>

#include <cmath>

#include "core/solver/memory.hpp"
#include "sluice/error.hpp"
#include "tests/support/simulation.hpp"

namespace sluice::test {
namespace {

std::string refusal(const Scene& scene, double available) {
  try {
    require_memory(scene, Precision::double_, available);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Memory, EnoughIsEnough) {
  const Scene scene = shipped("breaking_dam");
  const double need = memory_need(scene, Precision::double_).bytes;
  EXPECT_EQ(refusal(scene, need), "");
  EXPECT_NE(refusal(scene, need - 1), "");
}

TEST(Memory, RefusalNamesTheSpacingAndTheNeed) {
  const std::string message = refusal(shipped("breaking_dam", {"particles.spacing=0.01"}), 1e9);
  EXPECT_EQ(
      message.find(
          "--set particles.spacing: particles.spacing: found 0.01, which makes about 4.8e+08 particles"),
      0u)
      << message;
  EXPECT_NE(message.find("expected a scene that fits into the 1 GB of memory that are free"),
            std::string::npos);
}

TEST(Memory, CountsBeyond32BitsAreRefusedHoweverMuchMemoryThereIs) {
  EXPECT_NE(refusal(shipped("breaking_dam", {"particles.spacing=4e-3"}), 1e30).find("32-bit counts"),
            std::string::npos);
  EXPECT_NE(refusal(shipped("breaking_dam", {"domain.max=[1e9,1e9]"}), 1e30).find("grid cells"),
            std::string::npos);
}

TEST(Memory, ThisMachineHasSome) {
  EXPECT_GT(available_memory(), 1e8);
  EXPECT_TRUE(std::isfinite(available_memory()));
}

}  // namespace
}  // namespace sluice::test
