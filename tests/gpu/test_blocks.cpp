// What shaders declare stays within what OpenGL 4.3 promises.
#include <gtest/gtest.h>

#include "gpu/prelude.hpp"

namespace sluice::test {
namespace {

int occurrences(const std::string& text, const std::string& part) {
  int count = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

// OpenGL 4.3 promises a compute shader eight storage blocks and eight images, and no more.
TEST(Blocks, NoShaderDeclaresMoreThanEightBlocksOrImages) {
  for (uint32_t s = 0; s < stage_count; ++s) {
    const Stage stage = static_cast<Stage>(s);
    for (const gpu::Loads loads : {gpu::Loads::blocks, gpu::Loads::texels}) {
      const std::string text = gpu::prelude(stage, 0, 64, loads);
      EXPECT_LE(occurrences(text, "buffer "), 8) << info(stage).name;
      EXPECT_GE(occurrences(text, "buffer "), 1) << info(stage).name;
      EXPECT_LE(occurrences(text, "mageBuffer "), 8) << info(stage).name;
    }
  }
}

}  // namespace
}  // namespace sluice::test
