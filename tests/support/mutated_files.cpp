// From seeds to mutants of files to claims.
#include "tests/support/mutated_files.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>

#include "core/error.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/scene_claims.hpp"

namespace sluice::test {
namespace {

/// The claim that the file breaks, or nothing.
std::string broken_by(const FileKind& kind, const std::filesystem::path& path, uint64_t& loaded) {
  try {
    const std::string broken = kind.read(path);
    ++loaded;
    return broken;
  } catch (const InputError& error) {
    if (is_refusal_of(error.what(), fmt::format("{}: ", path.string()))) return "";
    return fmt::format("refused with \"{}\"", error.what());
  } catch (const std::exception& error) {
    return fmt::format("an error that is no InputError: {}", error.what());
  }
}

}  // namespace

void expect_claims_of_files(const FileKind& kind, Seeds seeds) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / fmt::format("mutant.{}", kind.ending);
  uint64_t loaded = 0;
  for (uint64_t seed = seeds.first; seed < seeds.first + seeds.count; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Dice dice(seed);
    const std::string bytes = kind.mutant(dice);
    std::ofstream(path, std::ios::binary) << bytes;
    const double start = thread_seconds();
    EXPECT_EQ(broken_by(kind, path, loaded), "");
    EXPECT_LE(thread_seconds() - start, most_seconds);
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(loaded, seeds.count / 20);
  EXPECT_LT(loaded, seeds.count / 2);
}

}  // namespace sluice::test
