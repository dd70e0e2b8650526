// Pictures drawn from the GPU backend's buffers are those drawn from the snapshot, to the last byte: the
// particles lie there in another order, which shows where circles cover each other.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "draw/device_fluid.hpp"
#include "gpu/backend.hpp"
#include "tests/support/picture_test.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/simulation.hpp"
#include "tests/support/table.hpp"

namespace sluice::test {

using namespace study;
namespace {

using draw::DeviceFluid;
using Words = std::vector<std::string>;

/// A scene on the GPU backend.
struct GpuRun {
  Scene scene;
  Samples samples;
  std::unique_ptr<gpu::GpuBackend> backend;
  Simulator simulator;

  GpuRun(const Context& context, Scene scene_to_run)
      : scene(std::move(scene_to_run)),
        samples(sample(scene)),
        backend(gpu::make_backend(context)),
        simulator(scene, samples, *backend) {}
};

std::vector<double> values_of(const Snapshot& snapshot, Colour colour, double unit) {
  std::vector<double> values = colour == Colour::density ? snapshot.density : snapshot.pressure;
  if (colour == Colour::speed) {
    std::transform(snapshot.v.begin(), snapshot.v.end(), values.begin(),
                   [](Vec2 v) { return glm::length(v); });
  }
  for (double& value : values) value *= unit;
  return values;
}

class GpuFrames : public PictureTest {
 protected:
  static draw::Frame frame_of(Colour colour) {
    draw::Frame frame;
    frame.colour = colour;
    frame.low = colour == Colour::density ? 0.95 : 0;
    frame.high = colour == Colour::density ? 1.05 : 2000;
    return frame;
  }

  draw::Image drawn_from(draw::Renderer& renderer, const Snapshot& snapshot, Colour colour, double unit) {
    const std::vector<double> values = values_of(snapshot, colour, unit);
    draw::Frame frame = frame_of(colour);
    frame.fluid = snapshot.x;
    frame.value = values;
    return renderer.draw(frame);
  }

  draw::Image drawn_from(draw::Renderer& renderer, draw::DeviceFluid& fluid, const GpuRun& run, Colour colour,
                         double unit) {
    fluid.collect(*run.backend, run.samples.fluid.size(), colour, unit);
    return renderer.draw(frame_of(colour), &fluid.cloud());
  }

  /// Compares both ways of drawing for every colour; circles overlap.
  void expect_same_pictures(const GpuRun& run, draw::DeviceFluid& fluid, draw::ParticleShape shape) {
    draw::Renderer renderer(context, {240, 360}, run.scene.domain_min, run.scene.domain_max,
                            2.5 * run.scene.spacing, shape);
    renderer.set_boundary(run.samples.boundary);
    const Snapshot snapshot = run.simulator.snapshot();
    for (const Colour colour : {Colour::speed, Colour::density, Colour::pressure}) {
      const double unit = colour == Colour::speed ? run.scene.dt / run.scene.spacing : 1 / 1.01;
      const draw::Image expected = drawn_from(renderer, snapshot, colour, unit);
      EXPECT_TRUE(drawn_from(renderer, fluid, run, colour, unit).rgb == expected.rgb)
          << "colour " << static_cast<int>(colour) << ", step " << snapshot.step;
    }
  }
};

TEST_F(GpuFrames, AreThoseOfTheSnapshotToTheLastByte) {
  GpuRun run(context, shipped("breaking_dam", {"domain.min=[-0.1,0.7]"}));
  draw::DeviceFluid fluid(context);
  for (const uint64_t step : {0, 1, 2, 90}) {
    while (run.simulator.steps() < step) run.simulator.step();
    for (const auto shape : {draw::ParticleShape::automatic, draw::ParticleShape::quads})
      expect_same_pictures(run, fluid, shape);
  }
}

// What the comparison above must not let pass: circles in the order of cells.
TEST_F(GpuFrames, AnotherOrderIsSeen) {
  GpuRun run(context, shipped("breaking_dam"));
  for (int step = 0; step < 90; ++step) run.simulator.step();
  const Snapshot snapshot = run.simulator.snapshot();
  Snapshot unsorted = snapshot;
  run.backend->download(Field::p, std::span(unsorted.pressure));
  std::vector<double> x(2 * snapshot.x.size());
  run.backend->download(Field::x_in, std::span(x));
  for (size_t i = 0; i < unsorted.x.size(); ++i) unsorted.x[i] = {x[2 * i], x[2 * i + 1]};
  draw::Renderer renderer(context, {240, 360}, run.scene.domain_min, run.scene.domain_max,
                          2.5 * run.scene.spacing);
  EXPECT_FALSE(drawn_from(renderer, unsorted, Colour::pressure, 1).rgb ==
               drawn_from(renderer, snapshot, Colour::pressure, 1).rgb);
}

// Here a float has no digits behind the point: the corner must not be rounded to one.
TEST_F(GpuFrames, FarFromTheOriginNothingChanges) {
  GpuRun run(context, shipped("breaking_dam", {"boundary.container=[]", "domain.min=[8388608.3,0]",
                                               "domain.max=[8389008,600]", "fluid.rect.0.min=[8388632,24]",
                                               "fluid.rect.0.max=[8388832,264]"}));
  draw::DeviceFluid fluid(context);
  expect_same_pictures(run, fluid, draw::ParticleShape::automatic);
}

TEST_F(GpuFrames, TheLargestValueIsThatOfTheSnapshot) {
  GpuRun run(context, shipped("breaking_dam"));
  draw::DeviceFluid fluid(context);
  const size_t n = run.samples.fluid.size();
  const auto expect_largest = [&](Colour colour, double unit) {
    fluid.collect(*run.backend, n, colour, unit);
    const std::vector<double> values = values_of(run.simulator.snapshot(), colour, unit);
    EXPECT_EQ(fluid.largest(), static_cast<float>(*std::max_element(values.begin(), values.end())));
  };
  expect_largest(Colour::density, 1);
  expect_largest(Colour::pressure, 1);
  EXPECT_EQ(fluid.largest(), 0) << "the start is without pressure";
  for (int step = 0; step < 20; ++step) run.simulator.step();
  expect_largest(Colour::pressure, 1);
  EXPECT_GT(fluid.largest(), 0);
  expect_largest(Colour::speed, 0.01);
}

/// The pictures of a run in small, in their order.
std::vector<draw::Image> pictures(const std::string& backend, const Words& more, int code = 0) {
  const TemporaryFolder folder;
  Words words{"run",     "breaking_dam", "--backend", backend,    "--threads", "1",
              "--quiet", "--size",       "120x180",   "--frames", folder.path};
  words.insert(words.end(), more.begin(), more.end());
  const ProgramResult result = run_program(words);
  EXPECT_EQ(result.code, code) << result.err;
  std::vector<draw::Image> images;
  for (const std::string& name : names_in(folder.path)) images.push_back(read_image(folder / name));
  return images;
}

int largest_difference(const draw::Image& a, const draw::Image& b) {
  if (a.rgb.size() != b.rgb.size()) return 256;
  int largest = 0;
  for (size_t k = 0; k < a.rgb.size(); ++k) largest = std::max(largest, std::abs(a.rgb[k] - b.rgb[k]));
  return largest;
}

// A graphics card may round otherwise than the processor does; a software device gives its bits.
TEST_F(GpuFrames, OfTheProgramAreThoseOfTheCpuBackend) {
  const Words converging{"--colour", "pressure",
                         "--set",    "fluid.gravity=[0,0]",
                         "--set",    "fluid.rect.0.velocity_gradient=[[-0.5,0],[0,-0.5]]"};
  for (Words words : {Words{}, Words{"--colour", "density"}, Words{"--colour", "pressure"}, converging}) {
    words.insert(words.end(), {"--steps", "6", "--fps", "25"});
    const std::vector<draw::Image> expected = pictures("cpu", words), found = pictures("gpu", words);
    ASSERT_EQ(expected.size(), 7u);
    ASSERT_EQ(found.size(), expected.size());
    EXPECT_FALSE(expected.front().rgb == expected.back().rgb);
    for (size_t k = 0; k < found.size(); ++k)
      EXPECT_LE(largest_difference(found[k], expected[k]), context.software() ? 0 : 1) << "picture " << k;
  }
}

// With a shader of the user's that moves all particles out of sight, the program has none to draw.
TEST_F(GpuFrames, OfTheProgramComeFromTheBuffers) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "draw");
  std::ofstream(folder / "draw/draw_order.comp") << R"(#version 430 core
layout(local_size_x = 64) in;
layout(std430) buffer position_block { vec2 position[]; };
uniform uint count;
void main() {
  if (gl_GlobalInvocationID.x < count) position[gl_GlobalInvocationID.x] = vec2(-1e6);
}
)";
  const Words still{"--steps", "0", "--overlay", "none"};
  Words emptied = still;
  emptied.insert(emptied.end(), {"--shader-dir", folder.path});
  const auto has_blue = [](const draw::Image& image) {  // particles at rest
    for (size_t k = 0; k < image.rgb.size(); k += 3) {
      if (image.rgb[k] == 0 && image.rgb[k + 2] == 255) return true;
    }
    return false;
  };
  EXPECT_TRUE(has_blue(pictures("gpu", still).at(0)));
  EXPECT_FALSE(has_blue(pictures("gpu", emptied).at(0)));
  EXPECT_TRUE(has_blue(pictures("cpu", emptied).at(0)));
}

// The first step leads to infinite velocities, so there is nothing later to show than the start.
TEST_F(GpuFrames, AFailedRunEndsWithItsLastFiniteState) {
  const std::vector<draw::Image> images =
      pictures("gpu",
               {"--steps", "1", "--fps", "0.01", "--overlay", "none", "--set", "pressure.method=ssph",
                "--set", "pressure.ssph.dt=100", "--set", "fluid.gravity=[0,-3e38]"},
               1);
  ASSERT_EQ(images.size(), 2u);
  EXPECT_TRUE(images[1].rgb == images[0].rgb);
}

}  // namespace
}  // namespace sluice::test
