// The library on OpenGL: a device that owns its context, and pictures.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "gpu/context.hpp"
#include "sluice/cpu.hpp"
#include "sluice/gpu.hpp"
#include "sluice/load.hpp"
#include "sluice/pictures.hpp"
#include "tests/support/run_program.hpp"

namespace sluice::test {
namespace {

Scene dam() { return load_scene("breaking_dam", {"output.size=[160, 240]"}); }

TEST(GpuLibrary, ADeviceOwnsItsContextAndHasTheBitsOfTheProcessor) {
  Simulation made(dam(), gpu::device({.particles = 660}));
  made.step();
  Simulation gpu = std::move(made), cpu(dam(), cpu::device());
  cpu.step();
  for (int k = 0; k < 9; ++k) gpu.step(), cpu.step();
  EXPECT_EQ(gpu.device().name(), "gpu");
  EXPECT_FALSE(gpu.field_in_memory("rho").in_place);
  if (!gpu::Context().software()) {  // bits are llvmpipe's
    const auto a = gpu.field("position").as<double>(), b = cpu.field("position").as<double>();
    for (size_t k = 0; k < a.size(); ++k) ASSERT_NEAR(a[k], b[k], 0.01 * dam().spacing);
    return;
  }
  for (const char* name : {"position", "velocity", "density", "pressure", "a_p", "A_ii"}) {
    const auto a = gpu.field(name).as<double>(), b = cpu.field(name).as<double>();
    EXPECT_TRUE(std::ranges::equal(a, b)) << name;
  }
  const auto a = gpu.field_in_memory("rho").as<float>(), b = cpu.field_in_memory("rho").as<float>();
  EXPECT_TRUE(std::ranges::equal(a, b));
}

TEST(GpuLibrary, DevicesThatAreNotThereAreRefused) {
  EXPECT_THROW(gpu::device({.gl_device = 99}), InputError);
  EXPECT_THROW(gpu::device({.shader_dir = "/nowhere"}), InputError);
}

TEST(GpuLibrary, PicturesAreThoseOfTheSizeAndColour) {
  Simulation cpu(dam(), cpu::device());
  cpu.run(0.2);
  media::Pictures as_scene(cpu.scene()),
      pressures(dam(), {.size = glm::uvec2(100, 90), .colour = Colour::pressure});
  const draw::Image first = as_scene.draw(cpu.snapshot(), cpu.dt());
  EXPECT_EQ(first.width, 160u);
  EXPECT_EQ(first.height, 240u);
  media::Pictures moved = std::move(pressures);
  const draw::Image second = moved.draw(cpu.snapshot(), cpu.dt());
  EXPECT_EQ(second.rgb.size(), 100u * 90 * 3);
  EXPECT_GT(std::set(second.rgb.begin(), second.rgb.end()).size(), 20u);
  const TemporaryFolder folder;
  media::write_png(folder / "picture.png", second);
  EXPECT_EQ(read_file(folder / "picture.png").substr(1, 3), "PNG");
  EXPECT_THROW(media::Pictures(dam(), {.size = glm::uvec2(4, 4)}), InputError);
}

}  // namespace
}  // namespace sluice::test
