// Builds without a window and without recordings: what is left out says how to get it.
#include <gtest/gtest.h>

#include <fstream>

#include "core/output/checkpoint.hpp"
#include "media/recording.hpp"
#include "media/window.hpp"
#include "tests/support/message_of.hpp"
#include "tests/support/run_program.hpp"

namespace sluice::test {
namespace {

TEST(Without, AWindowSaysHowToGetOne) {
  EXPECT_EQ(message_of([] {
              media::Window({100, 100}, "title");
            }),
            "this program was built without a window; run scripts/setup and build it again with "
            "-DSLUICE_GPU=ON -DSLUICE_WINDOW=ON");
}

TEST(Without, RecordingsSayHowToGetThem) {
  const std::string message =
      "this program was built without recordings; run scripts/setup and build it again "
      "with -DSLUICE_RECORDINGS=ON";
  EXPECT_EQ(message_of([] { media::RecordingWriter("a.rec", Scene(), Precision::single_, "device"); }),
            message);
  EXPECT_EQ(message_of([] { media::Recording("a.rec"); }), message);
  const TemporaryFolder folder;
  { std::ofstream(folder / "a.rec") << "sluice recording and more"; }
  EXPECT_TRUE(media::is_recording(folder / "a.rec")) << "or it would be taken for a scene";
}

TEST(Without, CheckpointsSayHowToGetThem) {
  const std::string message =
      "this program was built without checkpoints; run scripts/setup and build it again "
      "with -DSLUICE_RECORDINGS=ON";
  EXPECT_EQ(message_of([] { CheckpointWriter("a.ckp", Scene(), Precision::single_, "device"); }), message);
  EXPECT_EQ(message_of([] { read_checkpoint("a.ckp"); }), message);
}

}  // namespace
}  // namespace sluice::test
