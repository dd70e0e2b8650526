// Buffers that are too large for shaders are refused before anything runs; those beyond the driver's stated
// limit are tried first.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/output/output_file.hpp"
#include "sluice/error.hpp"
#include "tests/support/gpu.hpp"
#include "tests/support/run_program.hpp"

namespace sluice::test {
namespace {

/// More than the 128 MiB that Mesa's software driver states, in a field of 32-bit numbers.
constexpr uint64_t many = (uint64_t{130} << 20) / 4;

/// The message of the EnvironmentError that this throws; nothing when it throws none.
template <class Action>
std::string refusal(Action action) {
  try {
    action();
  } catch (const EnvironmentError& error) {
    return error.what();
  }
  return "";
}

TEST(GpuStorage, MoreThanShadersCanAddressIsRefused) {
  Gpu gpu;
  EXPECT_EQ(refusal([&] { gpu.allocate({Field::x_in}, {.fluid = uint64_t{1} << 30}); }),
            "x_in needs 8.59 GB in one buffer, more than shaders can address; use fewer particles, or "
            "--backend cpu");
  EXPECT_EQ(refusal([&] { gpu.allocate({Field::gradient}, {.list = uint64_t{1} << 29}); }).substr(0, 22),
            "gradient needs 4.29 GB");
  gpu.allocate({Field::index, Field::gradient}, {.fluid = 16, .list = 16});
  EXPECT_NE(refusal([&] { gpu.resize_list(uint64_t{1} << 30); }), "");
}

TEST(GpuStorage, BeyondTheStatedLimitStagesReachTheWholeBuffer) {
  Gpu gpu;
  gpu.allocate({Field::C}, {.cells = many - 1});
  std::vector<uint32_t> values(many);
  values.front() = 3;
  values[many / 2] = 5;
  values.back() = 7;
  gpu.backend->upload(Field::C, values);
  gpu.backend->run(Stage::grid_scan);
  const std::vector<uint32_t> sums = gpu.integers(Field::C);
  EXPECT_EQ(sums.front(), 3u);
  EXPECT_EQ(sums[many / 2 - 1], 3u);
  EXPECT_EQ(sums[many / 2], 8u);
  EXPECT_EQ(sums.back(), 15u);
}

TEST(GpuStorage, MoreThanTheCardHasIsRefused) {
  Gpu gpu({.free_bytes = 1'000'000});
  EXPECT_NO_THROW(
      gpu.allocate({Field::x_in, Field::index, Field::gradient}, {.fluid = 10'000, .list = 1000}));
  const std::string needed = "the fields need 1.2 MB of graphics memory, and " + gpu.context.renderer() +
                             " has 1 MB free; use fewer particles, or --backend cpu";
  EXPECT_EQ(refusal([&] { gpu.allocate({Field::x_in}, {.fluid = 150'000}); }), needed);
  EXPECT_EQ(refusal([&] { gpu.resize_list(100'000); }), needed);
}

/// A folder whose shader for the trial is this.
struct Trial {
  explicit Trial(const std::string& body) {
    std::filesystem::create_directory(folder / "lib");
    write_file(
        folder / "lib/probe_storage.comp",
        "#version 430 core\nlayout(local_size_x = 1) in;\n"
        "layout(std430) buffer probe_block { uint words[]; };\nuniform uint last, mark;\nvoid main() { " +
            body + " }\n");
  }
  TemporaryFolder folder;
};

TEST(GpuStorage, ABufferWhoseEndShadersDoNotReachIsRefused) {
  const Trial trial("if (last < 32u * 1024u * 1024u) words[last] = mark;");
  Gpu gpu({}, gpu::ShaderLibrary(trial.folder.path));
  const std::string message = refusal([&] { gpu.allocate({Field::cell}, {.fluid = many}); });
  EXPECT_TRUE(
      message.starts_with("cell needs 136 MB in one buffer, and shaders on " + gpu.context.renderer()))
      << message;
  EXPECT_TRUE(message.ends_with("; use fewer particles, or --backend cpu")) << message;
}

TEST(GpuStorage, WithinTheStatedLimitNothingIsTried) {
  const Trial trial("nonsense");
  Gpu gpu({}, gpu::ShaderLibrary(trial.folder.path));
  EXPECT_NO_THROW(gpu.allocate({Field::cell}, {.fluid = 1'000'000}));
}

}  // namespace
}  // namespace sluice::test
