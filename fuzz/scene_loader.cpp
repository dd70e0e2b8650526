// libFuzzer on the scene loader: whatever is in a file, the loader takes it or refuses it by name, in one
// line, and what it takes is finite (tests/support/scene_claims.hpp). Needs clang; Debian's clang package
// brings libFuzzer along.
//
//   cmake --preset fuzz && cmake --build --preset fuzz
//   mkdir -p build/fuzz/found && build/fuzz/scene_loader -dict=build/fuzz/scene.dict -max_total_time=600
//   build/fuzz/found scenes tests/data
//
// New inputs of interest go to the first folder; the others are only read. An input that breaks a claim, or
// takes longer than -timeout says, is written to the working folder as crash-... or timeout-...; to run it
// again, give that file as the only argument. Make a test of it (tests/scene/test_scene_refusals.cpp) before
// you mend it.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "tests/support/scene_claims.hpp"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  constexpr double memory = 4e6, seconds = 5;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const sluice::test::Judgement judgement = sluice::test::judge_scene(text, {}, memory, seconds);
  if (judgement.broken.empty()) return 0;
  std::fprintf(stderr, "%s\n", judgement.broken.c_str());
  std::abort();
}
