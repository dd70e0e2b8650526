// sluice_recording_bench: what a frame of a recording costs: to write, to read wherever it is, and to read
// and draw, in a scene of 7220 particles. The figures in docs/watching.md are from here.
#include <benchmark/benchmark.h>

#include <filesystem>
#include <string>
#include <vector>

#include "core/solver/simulator.hpp"
#include "cpu/backend.hpp"
#include "draw/painter.hpp"
#include "gpu/context.hpp"
#include "media/recording.hpp"
#include "sluice/load.hpp"

namespace sluice::bench {
namespace {

constexpr uint64_t steps = 500;

std::filesystem::path temporary(const char* name) { return std::filesystem::temp_directory_path() / name; }

/// A dam of 7220 particles.
const std::vector<std::string> finer = {"particles.spacing=2.55", "time.dt=0.0125",
                                        "viscosity.coefficient=60"};

/// A recording of it with a frame for every step, removed at the end.
struct Recorded {
  std::filesystem::path path = temporary("sluice_recording_bench.rec");
  Scene scene = load_scene("breaking_dam", finer);
  Samples samples = sample(scene);
  media::Moment last;

  Recorded() {
    const auto backend = cpu::make_backend(Precision::single_, cpu::hardware_threads());
    Simulator simulator(scene, samples, *backend);
    media::RecordingWriter writer(path, scene, Precision::single_, "bench");
    for (uint64_t k = 0; k < steps; ++k) {
      last.report = simulator.step();
      last.state = simulator.snapshot();
      writer.add(last.report, 0, last.state);
    }
    writer.commit();
  }
  ~Recorded() { std::filesystem::remove(path); }
};

const Recorded& recorded() {
  static const Recorded made;
  return made;
}

/// Frames in an order that has nothing to do with theirs.
std::vector<size_t> jumps(size_t frames) {
  std::vector<size_t> order(frames);
  for (size_t k = 0; k < frames; ++k) order[k] = k * 211 % frames;
  return order;
}

void open_recording(benchmark::State& state) {
  const auto path = recorded().path;
  for (auto _ : state) benchmark::DoNotOptimize(media::Recording(path).frames());
  state.SetBytesProcessed(state.iterations() * static_cast<int64_t>(std::filesystem::file_size(path)));
}
BENCHMARK(open_recording)->Unit(benchmark::kMillisecond);

void write_frame(benchmark::State& state) {
  media::Moment moment = recorded().last;
  const auto path = temporary("sluice_recording_bench_written.rec");
  {
    media::RecordingWriter writer(path, recorded().scene, Precision::single_, "bench");
    for (auto _ : state) {
      ++moment.report.step;
      writer.add(moment.report, 0, moment.state);
    }
  }
  std::filesystem::remove(path);
}
BENCHMARK(write_frame)->Unit(benchmark::kMillisecond);

void read_any_frame(benchmark::State& state) {
  const media::Recording recording(recorded().path);
  const std::vector<size_t> order = jumps(recording.frames());
  size_t k = 0;
  for (auto _ : state) benchmark::DoNotOptimize(recording.moment(order[k++ % order.size()]));
}
BENCHMARK(read_any_frame)->Unit(benchmark::kMillisecond);

void read_and_draw_any_frame(benchmark::State& state) {
  const media::Recording recording(recorded().path);
  const gpu::Context context;
  draw::Painter painter(context, recording.scene(), recording.samples(), recording.scene().image_size);
  const std::vector<size_t> order = jumps(recording.frames());
  size_t k = 0;
  for (auto _ : state) {
    const media::Moment moment = recording.moment(order[k++ % order.size()]);
    painter.paint(draw::Frame(), moment.report.dt, moment.state);
    benchmark::DoNotOptimize(painter.renderer().read());
  }
}
BENCHMARK(read_and_draw_any_frame)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace sluice::bench

BENCHMARK_MAIN();
