// `sluice play`: a scene, a recording, or the list of scenes in a window.
#include <fmt/format.h>

#include <algorithm>

#include "apps/sluice/commands.hpp"
#include "apps/sluice/play/menu.hpp"
#include "apps/sluice/play/recording.hpp"
#include "apps/sluice/play/scene.hpp"
#include "core/output/checkpoint.hpp"
#include "sluice/error.hpp"
#include "sluice/load.hpp"

namespace sluice::app {
namespace {

/// What belongs to a run is refused for a recording, which is one already.
void refuse_options_of_runs(const PlayOptions& options) {
  const bool changes_scene = std::ranges::any_of(
      options.overrides, [](const std::string& text) { return !text.starts_with("output."); });
  if (options.machine.backend == BackendChoice::automatic &&
      options.machine.precision == Precision::single_ && !options.machine.instructions && !options.steps &&
      !options.time && !changes_scene)
    return;
  throw InputError(
      fmt::format("{}: found a recording with an option of runs (--backend, --precision, --instructions, "
                  "--steps, --time, --set other "
                  "than of output), expected a scene with it",
                  options.source));
}

int play_recording(const PlayOptions& options) {
  refuse_options_of_runs(options);
  media::Recording recording(options.source, options.overrides);
  Viewer viewer(recording.scene().image_size, options.overlay, options.machine.shader_dir);
  RecordingPlayer(std::move(recording), options.speed, viewer).run();
  return 0;
}

}  // namespace

int play_command(const PlayOptions& options) {
  if (!options.source.empty() && media::is_recording(options.source)) return play_recording(options);
  glm::uvec2 size = menu_size;
  if (!options.source.empty()) refuse_checkpoint(options.source);
  if (!options.source.empty()) {  // a scene that can't be read needs no window to say so
    const Scene scene = load_choice({options.source, options.overrides, std::nullopt});
    size = scene.image_size;
    if (options.machine.backend == BackendChoice::gpu)
      gpu::suit_software_threads(static_cast<uint64_t>(sample_bounds(scene).fluid));
  }
  Viewer viewer(size, options.overlay, options.machine.shader_dir);
  if (!options.source.empty()) {
    ScenePlayer(options, options.source, viewer).run();
    return 0;
  }
  while (const std::optional<std::string> scene = choose_scene(viewer)) {
    try {
      ScenePlayer(options, *scene, viewer).run();
    } catch (const InputError& error) {  // what --set asks for may fit another scene
      viewer.say(error.what());
    }
  }
  return 0;
}

}  // namespace sluice::app
