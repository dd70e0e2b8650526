// Runs of mutants of the scenes through the claims about them, shared by both suites.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace sluice::test {

/// The texts of the shipped scenes and of those in tests/data.
std::vector<std::string> scene_corpus();

/// Seeds of mutants: first to first + count - 1.
struct Seeds {
  uint64_t first = 0, count = 0;
};

/// Makes a scene file from every seed and expects all claims of judge_scene, and that some of the files are
/// refused, some loaded and some sampled.
void expect_claims_of_scenes(Seeds seeds);

/// Makes one to three overrides of a shipped scene from every seed and expects the same.
void expect_claims_of_overrides(Seeds seeds);

}  // namespace sluice::test
