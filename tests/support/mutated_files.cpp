// From seeds to mutants of files to claims.
#include "tests/support/mutated_files.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/output/checked_file.hpp"
#include "core/solver/memory.hpp"
#include "sluice/error.hpp"
#include "sluice/load.hpp"
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

/// Whether the header asks for a scene that takes long because it is large, which is no mistake of the
/// reader.
bool asks_for_much(const std::string& header) {
  constexpr double memory = 64e6;
  const auto json = nlohmann::json::parse(header, nullptr, false);
  try {
    const auto overrides = json.at("overrides").get<std::vector<std::string>>();
    const Scene scene = parse_scene(json.at("text").get<std::string>(), "a", overrides);
    require_memory(scene, Precision::double_, memory);
  } catch (const InputError& error) {
    return std::string_view(error.what()).find("particles.spacing") != std::string_view::npos;
  } catch (const nlohmann::json::exception&) {
    return false;
  }
  return false;
}

}  // namespace

std::string changed_header(const std::string& header, Dice& dice) {
  std::string changed = header;
  for (size_t changes = 1 + dice.below(3); changes > 0; --changes)
    dice.of(dice.one_in(2) ? byte_mutations() : scene_mutations())(changed, dice, std::span(&header, 1));
  return asks_for_much(changed) ? header : changed;
}

void change_numbers(std::string& numbers, Dice& dice) {
  static constexpr std::array<double, 8> extreme{NAN, INFINITY, -INFINITY, 1e308, -0.0, 5e-324, 1e30, -1};
  const bool aligned = dice.one_in(2);
  const size_t at =
      aligned ? 8 * dice.below(std::min<size_t>(numbers.size() / 8, 24)) : dice.below(numbers.size() - 8);
  numbers.replace(at, 8, bytes_of(extreme[dice.below(extreme.size())]));
}

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
