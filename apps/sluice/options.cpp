// Options of `sluice run`. Those of later versions are known by name and refused.
#include "apps/sluice/options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "cpu/backend.hpp"

namespace sluice {
namespace {

/// An option that takes one of a few names.
template <class T, class Use>
CLI::Option* add_choice(CLI::App& app, const std::string& name, Use use,
                        std::vector<std::pair<std::string, T>> choices, const std::string& help) {
  const auto read = [name, use, choices = std::move(choices)](const std::string& text) {
    std::string known;
    for (const auto& [choice, meaning] : choices) {
      if (text == choice) {
        use(meaning);
        return;
      }
      known += (known.empty() ? "" : ", ") + choice;
    }
    throw InputError(fmt::format("{}: found \"{}\", expected one of {}", name, text, known));
  };
  return app.add_option_function<std::string>(name, read, help)->type_name("WHICH");
}

/// Reads "640x480".
void add_size(const std::string& text, RunOptions& options) {
  uint32_t width = 0, height = 0;
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, width);
  const bool crossed = first.ec == std::errc() && first.ptr != end && *first.ptr == 'x';
  const auto second = crossed ? std::from_chars(first.ptr + 1, end, height) : first;
  if (!crossed || second.ec != std::errc() || second.ptr != end || width < 16 || height < 16 ||
      width > 16384 || height > 16384) {
    throw InputError(
        fmt::format("--size: found \"{}\", expected WIDTHxHEIGHT in pixels, each 16 to 16384, as in "
                    "--size 800x600",
                    text));
  }
  options.overrides.push_back(fmt::format("output.size=[{},{}]", width, height));
}

/// A file or folder to write. An empty word, as from an unset variable of a shell, is no wish for no file.
CLI::Option* add_path(CLI::App& app, const std::string& name, std::optional<std::filesystem::path>& path,
                      const std::string& help) {
  const auto read = [name, &path](const std::string& text) {
    if (text.empty())
      throw InputError(fmt::format("{}: found an empty name, expected a file or folder", name));
    path = text;
  };
  return app.add_option_function<std::string>(name, read, help);
}

/// The whole of `text` as a number; an empty word, as from an unset variable of a shell, is none.
template <class T>
std::optional<T> number_in(const std::string& text) {
  T value{};
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || rest != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Reads an option's number, one that is not `wanted` is refused.
template <class T, class Wanted, class Use>
CLI::Option* add_number(CLI::App& app, const std::string& name, const std::string& expected, Wanted wanted,
                        Use use, const std::string& help) {
  const auto read = [name, expected, wanted, use](const std::string& text) {
    const std::optional<T> value = number_in<T>(text);
    if (!value || !wanted(*value)) {
      throw InputError(fmt::format("{}: found \"{}\", expected {}", name, text, expected));
    }
    use(*value);
  };
  return app.add_option_function<std::string>(name, read, help);
}

void add_later_options(CLI::App& app) {
  for (const char* name :
       {"--checkpoint", "--checkpoint-every", "--resume", "--record", "--video", "--vtk"}) {
    app.add_option_function<std::string>(
           name,
           [name](const std::string&) {
             throw InputError(fmt::format("{}: this option is not available yet", name));
           },
           "Not available yet")
        ->group("Not available yet");
  }
}

void add_output_options(CLI::App& app, RunOptions& options) {
  add_path(app, "--state", options.state, "Write the last state: id,x,y,vx,vy,density,pressure")
      ->type_name("FILE.csv")
      ->group("Output");
  add_path(app, "--series", options.series, "Write one row per step: iterations, density, energies, ...")
      ->type_name("FILE.csv")
      ->group("Output");
  add_path(app, "--summary", options.summary, "Write counts, means, timings and settings")
      ->type_name("FILE.json")
      ->group("Output");
  app.add_flag("--quiet", options.quiet, "No progress, no table at the end")->group("Output");
}

void add_picture_options(CLI::App& app, RunOptions& options) {
  add_path(app, "--frames", options.frames, "Write pictures frame_000000.png, ... into this folder")
      ->type_name("DIR")
      ->group("Pictures");
  add_number<double>(
      app, "--fps", "a number greater than 0", [](double fps) { return fps > 0 && std::isfinite(fps); },
      [&](double fps) { options.overrides.push_back(fmt::format("output.fps={:.17g}", fps)); },
      "Pictures per simulated second; overrides output.fps")
      ->type_name("F")
      ->group("Pictures");
  app.add_option_function<std::string>(
         "--size", [&](const std::string& text) { add_size(text, options); },
         "Picture size in pixels; overrides output.size")
      ->type_name("WxH")
      ->group("Pictures");
  add_choice<std::string>(
      app, "--colour", [&](const std::string& name) { options.overrides.push_back("output.colour=" + name); },
      {{"speed", "speed"}, {"density", "density"}, {"pressure", "pressure"}},
      "Colour particles by speed, density or pressure; overrides output.colour")
      ->group("Pictures");
  add_choice<OverlayChoice>(
      app, "--overlay", [&](OverlayChoice overlay) { options.overlay = overlay; },
      {{"none", OverlayChoice::none}, {"facts", OverlayChoice::facts}, {"all", OverlayChoice::all}},
      "Text on the pictures: none, facts (default), all (with ms per step)")
      ->group("Pictures");
}

void declare_scene(CLI::App& app, std::string& scene, std::vector<std::string>& overrides) {
  app.add_option("SCENE", scene, "A scene file, or the name of a shipped scene (`sluice scenes`)")
      ->required();
  declare_overrides(app, overrides);
}

void declare_threads(CLI::App& app, MachineOptions& options) {
  options.threads = cpu::hardware_threads();
  add_number<int>(
      app, "--threads", "1 to 1024", [](int threads) { return threads >= 1 && threads <= 1024; },
      [&](int threads) { options.threads = threads; },
      "Threads of the CPU backend; results do not depend on it")
      ->type_name("N");
}

}  // namespace

void declare_overrides(CLI::App& app, std::vector<std::string>& overrides) {
  app.add_option("--set", overrides,
                 "Change a key of the scene, as in --set pressure.method=ssph; repeatable")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void declare_gl_options(CLI::App& app, MachineOptions& options) {
  add_number<int>(
      app, "--gl-device", "a number that `sluice info` lists", [](int device) { return device >= 0; },
      [&](int device) { options.gl_device = device; },
      "Compute and draw on EGL device N; `sluice info` lists them")
      ->type_name("N")
      ->group("OpenGL");
  add_path(app, "--shader-dir", options.shader_dir,
           "Take shaders from this folder, laid out as shaders/, where it has them")
      ->type_name("DIR")
      ->group("OpenGL");
}

void declare_agree_options(CLI::App& app, AgreeOptions& options) {
  declare_scene(app, options.scene, options.overrides);
  declare_threads(app, options.machine);
  declare_gl_options(app, options.machine);
  add_number<uint64_t>(
      app, "--steps", "a whole number from 1 on", [](uint64_t steps) { return steps > 0; },
      [&](uint64_t count) { options.steps = count; }, "Steps to run on both; 200 if not given")
      ->type_name("N");
  app.add_option(
         "--split", options.split,
         "Run each step on the CPU up to this stage and on the GPU after it, instead of all on the GPU")
      ->type_name("STAGE");
  add_path(app, "--summary", options.summary, "Write the table as JSON")->type_name("FILE.json");
}

void declare_run_options(CLI::App& app, RunOptions& options) {
  declare_scene(app, options.scene, options.overrides);
  add_choice<BackendChoice>(
      app, "--backend", [&](BackendChoice backend) { options.machine.backend = backend; },
      {{"auto", BackendChoice::automatic}, {"cpu", BackendChoice::cpu}, {"gpu", BackendChoice::gpu}},
      "auto (default) takes a graphics card if there is one, else the CPU; cpu; gpu: OpenGL compute shaders");
  add_choice<Precision>(
      app, "--precision", [&](Precision precision) { options.machine.precision = precision; },
      {{"float", Precision::single_}, {"double", Precision::double_}},
      "float (default) or double; double runs on the CPU");
  auto* steps = add_number<uint64_t>(
                    app, "--steps", "a whole number from 0 on", [](uint64_t) { return true; },
                    [&](uint64_t count) { options.steps = count; }, "Steps to run in place of time.duration")
                    ->type_name("N");
  add_number<double>(
      app, "--time", "a number from 0 on", [](double time) { return time >= 0 && std::isfinite(time); },
      [&](double time) { options.time = time; }, "Time to simulate in place of time.duration")
      ->type_name("T")
      ->excludes(steps);
  declare_threads(app, options.machine);
  declare_gl_options(app, options.machine);
  add_output_options(app, options);
  add_picture_options(app, options);
  add_later_options(app);
}

}  // namespace sluice
