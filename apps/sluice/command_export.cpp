// `sluice export`: pictures, a film or files for ParaView from a recording, without simulating again.
#include <fmt/format.h>

#include "apps/sluice/clashes.hpp"
#include "apps/sluice/commands.hpp"
#include "apps/sluice/frames.hpp"
#include "apps/sluice/interrupt.hpp"
#include "apps/sluice/progress.hpp"
#include "core/attempts.hpp"
#include "gpu/context.hpp"
#include "media/recording.hpp"
#include "sluice/error.hpp"

namespace sluice::app {

namespace {

/// How many there were time for.
size_t export_frames(const media::Recording& recording, FrameOutputs& outputs, bool quiet) {
  const double end = recording.moment(recording.frames() - 1).report.time;
  Progress progress(recording.frames(), end, "frames", quiet);
  size_t done = 0;
  try {
    for (; done < recording.frames() && !interrupted(); ++done) {
      const media::Moment moment = recording.moment(done);
      outputs.add(moment.report, moment.seconds_per_step, {[&] { return moment.state; }, nullptr});
      progress.show(done + 1, moment.report);
    }
  } catch (const Error&) {
    Attempts()([&] { outputs.finish(); });  // what there is is kept; the first failure is the news
    throw;
  }
  return done;
}

}  // namespace

int export_command(const ExportOptions& options) {
  if (!options.frames.frames && !options.frames.video && !options.frames.vtk) {
    throw InputError("export: found nothing to write, expected --frames DIR, --video FILE.mp4 or --vtk DIR");
  }
  refuse_clashes({{"the recording", options.recording},
                  {"--video", options.frames.video},
                  {"--frames", options.frames.frames},
                  {"--vtk", options.frames.vtk}});
  const media::Recording recording(options.recording, options.overrides);
  note_interrupts();  // from here on there is something to finish
  std::optional<gpu::Context> context;
  FrameOutputs outputs(options.frames, recording.scene(), recording.samples(), recording.precision(), "",
                       [&]() -> const gpu::Context& {
                         if (!context)
                           context.emplace(options.machine.gl_device,
                                           gpu::ShaderLibrary(options.machine.shader_dir));
                         return *context;
                       });
  const size_t done = export_frames(recording, outputs, options.quiet);
  outputs.finish();
  outputs.tell(options.quiet);
  if (interrupted()) {
    fmt::print(stderr,
               "sluice: interrupted after frame {} of {}; what was asked for is written up to there\n", done,
               recording.frames());
  }
  return 0;
}

}  // namespace sluice::app
