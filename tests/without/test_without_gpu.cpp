// Builds without OpenGL: the program computes on the processor, and says how to get what is left out.
#include <gtest/gtest.h>

#include "tests/support/run_program.hpp"

namespace sluice::test {
namespace {

using Words = std::vector<std::string>;

TEST(WithoutGpu, TheProgramComputesOnTheProcessor) {
  const TemporaryFolder folder;
  const ProgramResult result =
      run_program({"run", "breaking_dam", "--steps", "10", "--state", "s.csv"}, folder.path);
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_TRUE(std::filesystem::exists(folder / "s.csv"));
  EXPECT_EQ(run_program({"info"}).code, 0);
}

TEST(WithoutGpu, WhatNeedsOpenGlSaysHowToGetIt) {
  const TemporaryFolder folder;
  const std::vector<Words> needs_opengl{{"run", "breaking_dam", "--steps", "1", "--backend", "gpu"},
                                        {"run", "breaking_dam", "--steps", "1", "--frames", "pictures"},
                                        {"agree", "breaking_dam", "--steps", "1"},
                                        {"info", "breaking_dam", "--shader", "density"}};
  for (const Words& words : needs_opengl) {
    const ProgramResult result = run_program(words, folder.path);
    EXPECT_EQ(result.code, 3) << result.out;
    EXPECT_NE(result.err.find("this program was built without OpenGL"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("-DSLUICE_GPU=ON"), std::string::npos) << result.err;
  }
}

}  // namespace
}  // namespace sluice::test
