// Tests that are run once more in another world, by what ctest puts into the environment, are really in it.
// Each of these is run in its own world only.
#include <gtest/gtest.h>

#include <cstdlib>

#include "gpu/context.hpp"

namespace sluice::test {
namespace {

TEST(World, hardware) {
  EXPECT_FALSE(gpu::Context().software());
  EXPECT_NE(std::getenv("SLUICE_SHADER_DIR"), nullptr);
  EXPECT_STREQ(std::getenv("LP_NUM_THREADS"), "0");
}

TEST(World, softpipe) { EXPECT_NE(gpu::Context().renderer().find("softpipe"), std::string::npos); }

TEST(World, zink) { EXPECT_NE(gpu::Context().renderer().find("zink"), std::string::npos); }

}  // namespace
}  // namespace sluice::test
