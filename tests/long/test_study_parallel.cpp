// A study whose points GNU parallel runs, as docs/speed_against_error.md shows it.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/support/run_program.hpp"
#include "tests/support/table.hpp"

namespace sluice::test {

using namespace study;
namespace {

/// In the folder, with this program on the path.
void shell(const std::string& command, const std::filesystem::path& folder) {
  const std::string program = std::filesystem::path(SLUICE_BINARY).parent_path().string();
  const std::string line =
      "cd '" + folder.string() + "' && export PATH='" + program + "':\"$PATH\" && " + command;
  ASSERT_EQ(std::system(line.c_str()), 0) << command;
}

void expect_same_tables(const std::filesystem::path& folder) {
  ASSERT_EQ(run_program({"study", "density", "--out", "direct"}, folder).code, 0);
  for (const char* name : {"density.csv", "density_windows.csv", "density.md"})
    EXPECT_EQ(read_file(folder / "out" / name), read_file(folder / "direct" / name)) << name;
}

TEST(StudyOnACluster, ParallelRunsItsLines) {
  const TemporaryFolder folder;
  shell("sluice study density --out out --list >lines", folder.path);
  shell("parallel --jobs 2 --joblog log <lines", folder.path);
  shell("sluice study density --collect out >table.md", folder.path);
  expect_same_tables(folder.path);
  EXPECT_EQ(read_file(folder.path / "table.md"), read_file(folder.path / "out" / "density.md"));
}

TEST(StudyOnACluster, AnArrayOfJobsRunsALineEach) {
  const TemporaryFolder folder;
  shell("sluice study density --out out --list >lines", folder.path);
  shell(
      "for SLURM_ARRAY_TASK_ID in 1 2 3 4 5 6; do sed -n \"${SLURM_ARRAY_TASK_ID}p\" lines | sh || exit 1; "
      "done",
      folder.path);
  shell("sluice study density --collect out >table.md", folder.path);
  expect_same_tables(folder.path);
}

}  // namespace
}  // namespace sluice::test
