// Mutants of binary files through the claims about them: each is loaded or refused by name, in no time. A
// kind of file says how a mutant is made and how a file is read.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "tests/support/mutated_scenes.hpp"
#include "tests/support/mutation.hpp"

namespace sluice::test {

struct FileKind {
  std::string ending;
  /// The bytes of a mutant.
  std::function<std::string(Dice&)> mutant;
  /// Reads all of a file and returns the claim that doesn't hold of it, or nothing; errors go through.
  std::function<std::string(const std::filesystem::path&)> read;
};

/// Makes a file from every seed and expects that it is loaded, or refused with an InputError of one line that
/// begins with its name, and that some are refused and some loaded.
void expect_claims_of_files(const FileKind& kind, Seeds seeds);

/// Recordings of a few steps. Most mutants are given a new checksum, and every second one is put together
/// anew from a changed part, so that it lies where the rest of the file says.
FileKind recording_kind();

/// Checkpoints of a few steps, likewise.
FileKind checkpoint_kind();

/// The JSON at the beginning of such a file, changed; as it was where the change asks for a scene that takes
/// long because it is large, which is no mistake of the reader.
std::string changed_header(const std::string& header, Dice& dice);

/// Some number of `numbers`, or some bytes of them, replaced by an extreme one.
void change_numbers(std::string& numbers, Dice& dice);

}  // namespace sluice::test
