// Recordings and checkpoints that nobody would write, a right checksum and all, are loaded or refused by
// name, and nothing else: 400 of each, made from good ones by seeded changes. The long suite tries many more.
#include <gtest/gtest.h>

#include "tests/support/mutated_files.hpp"

namespace sluice::test {
namespace {

TEST(MutatedFiles, RecordingsAreLoadedOrRefused) { expect_claims_of_files(recording_kind(), {0, 400}); }
TEST(MutatedFiles, CheckpointsAreLoadedOrRefused) { expect_claims_of_files(checkpoint_kind(), {0, 400}); }

}  // namespace
}  // namespace sluice::test
