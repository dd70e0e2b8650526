// What the subcommands understand. The one place that knows the parser of the command line.
#include "apps/sluice/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <utility>

#include "apps/sluice/commands.hpp"
#include "apps/sluice/play/pace.hpp"
#include "core/output/summary.hpp"
#include "cpu/backend.hpp"
#include "sluice/error.hpp"
#include "sluice/version.hpp"

namespace sluice::app {
namespace {

/// An option that takes one of the names of an enum; `use` gets the value.
template <class Enum>
CLI::Option* add_choice(CLI::App& app, const std::string& name, const std::function<void(Enum)>& use,
                        const std::string& help) {
  const auto read = [name, use](const std::string& text) {
    if (const auto value = value_named<Enum>(text)) return use(*value);
    std::string known;
    for (const ChoiceInfo& choice : choices_of(Enum{}).rows)
      known += fmt::format("{}{}", known.empty() ? "" : ", ", choice.name);
    throw InputError(fmt::format("{}: found \"{}\", expected one of {}", name, text, known));
  };
  std::string meanings;
  for (const ChoiceInfo& choice : choices_of(Enum{}).rows)
    meanings += fmt::format("{}{}: {}", meanings.empty() ? "" : "; ", choice.name, choice.meaning);
  return app.add_option_function<std::string>(name, read, help + meanings)->type_name("WHICH");
}

void declare_overrides(CLI::App& app, std::vector<std::string>& overrides) {
  app.add_option("--set", overrides,
                 "Change a key of the scene, as in --set pressure.method=ssph; repeatable")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

/// Reads "640x480".
void add_size(const std::string& text, std::vector<std::string>& overrides) {
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
  overrides.push_back(fmt::format("output.size=[{},{}]", width, height));
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

void add_checkpoint_options(CLI::App& app, RunOptions& options) {
  auto* file = add_path(app, "--checkpoint", options.checkpoint,
                        "Write what a later run needs to go on from where this one ends")
                   ->type_name("FILE")
                   ->group("Checkpoints");
  add_number<double>(
      app, "--checkpoint-every", "a number greater than 0",
      [](double every) { return every > 0 && std::isfinite(every); },
      [&](double every) { options.checkpoint_every = every; },
      "Write it every T of simulated time too, each in the place of the last")
      ->type_name("T")
      ->group("Checkpoints")
      ->needs(file);
  add_path(app, "--resume", options.resume,
           "Go on from a checkpoint; SCENE may be left out. --steps and --time count from the scene's start")
      ->type_name("FILE")
      ->group("Checkpoints");
  add_path(app, "--start-from", options.start_from,
           "Start at time 0 with the particles of a checkpoint, as they are there, under any settings; SCENE "
           "may be left "
           "out")
      ->type_name("FILE")
      ->group("Checkpoints")
      ->excludes("--resume");
}

CLI::Option* add_fields(CLI::App& app, std::vector<std::string>& fields, const std::string& help) {
  return app.add_option("--dump", fields, help)->type_name("FIELD,")->delimiter(',')->allow_extra_args(false);
}

void add_output_options(CLI::App& app, RunOptions& options) {
  auto* state = add_path(app, "--state", options.state, "Write the last state: id,x,y,vx,vy,density,pressure")
                    ->type_name("FILE.csv")
                    ->group("Output");
  add_fields(
      app, options.dump,
      "Fields of the stages that the state has too, behind its other columns: a_p,A_ii (`sluice info SCENE` "
      "shows which there are)")
      ->group("Output")
      ->needs(state);
  add_path(app, "--series", options.series, "Write one row per step: iterations, density, energies, ...")
      ->type_name("FILE.csv")
      ->group("Output");
  add_path(app, "--sweeps", options.sweeps,
           "Write one row per sweep of the pressure solver: how far it has converged")
      ->type_name("FILE.csv")
      ->group("Output");
  add_path(app, "--probes", options.probes, "Write one row per step: what the probes of the scene measure")
      ->type_name("FILE.csv")
      ->group("Output");
  add_path(app, "--wall-forces", options.wall_forces,
           "Write one row per step: force and torque of the pressure on each boundary shape")
      ->type_name("FILE.csv")
      ->group("Output");
  add_path(app, "--summary", options.summary, "Write counts, means, timings and settings")
      ->type_name("FILE.json")
      ->group("Output");
  app.add_flag("--quiet", options.quiet, "No progress, no warnings, no table at the end")->group("Output");
}

void add_fps(CLI::App& app, std::vector<std::string>& overrides) {
  add_number<double>(
      app, "--fps", "a number greater than 0", [](double fps) { return fps > 0 && std::isfinite(fps); },
      [&](double fps) { overrides.push_back(fmt::format("output.fps={:.17g}", fps)); },
      "Frames per simulated second; overrides output.fps")
      ->type_name("F")
      ->group("Pictures");
}

/// How pictures look.
void add_picture_options(CLI::App& app, std::vector<std::string>& overrides, OverlayChoice& overlay,
                         const std::string& overlay_help) {
  app.add_option_function<std::string>(
         "--size", [&](const std::string& text) { add_size(text, overrides); },
         "Picture size in pixels; overrides output.size")
      ->type_name("WxH")
      ->group("Pictures");
  add_choice<Colour>(
      app, "--colour",
      [&](Colour colour) { overrides.push_back(fmt::format("output.colour={}", name_of(colour))); },
      "What colours show, in place of output.colour. ")
      ->group("Pictures");
  add_choice<OverlayChoice>(
      app, "--overlay", [&](OverlayChoice choice) { overlay = choice; }, overlay_help)
      ->group("Pictures");
}

void add_speed(CLI::App& app, double& speed, const std::string& help) {
  add_number<double>(
      app, "--speed", fmt::format("a number from {:g} to {:g}", least_speed, most_speed),
      [](double value) { return value >= least_speed && value <= most_speed; },
      [&](double value) { speed = value; }, help)
      ->type_name("F")
      ->group("Pictures");
}

/// What is made of frames.
void add_frame_outputs(CLI::App& app, std::vector<std::string>& overrides, FrameOptions& options) {
  add_path(app, "--frames", options.frames, "Write pictures frame_000000.png, ... into this folder")
      ->type_name("DIR")
      ->group("Pictures");
  add_path(app, "--video", options.video, "Write a film; needs ffmpeg")
      ->type_name("FILE.mp4")
      ->group("Pictures");
  add_speed(app, options.speed,
            "Simulated seconds per second of the film: 0.25 is slow motion; 1 if not given");
  add_path(app, "--vtk", options.vtk, "Write the particles of every frame into this folder, for ParaView")
      ->type_name("DIR")
      ->group("Output");
  add_picture_options(app, overrides, options.overlay, "Text on the pictures; facts if not given. ");
}

void add_steps_and_time(CLI::App& app, std::optional<uint64_t>& steps, std::optional<double>& time,
                        const std::string& in_place_of) {
  auto* count = add_number<uint64_t>(
                    app, "--steps", "a whole number from 0 on", [](uint64_t) { return true; },
                    [&](uint64_t value) { steps = value; }, "Steps to run " + in_place_of)
                    ->type_name("N");
  add_number<double>(
      app, "--time", "a number from 0 on", [](double value) { return value >= 0 && std::isfinite(value); },
      [&](double value) { time = value; }, "Time to simulate " + in_place_of)
      ->type_name("T")
      ->excludes(count);
}

constexpr const char* scene_help = "A scene file, or the name of a shipped scene (`sluice scenes`)";

void declare_scene(CLI::App& app, std::string& scene, std::vector<std::string>& overrides) {
  app.add_option("SCENE", scene, scene_help)->required();
  declare_overrides(app, overrides);
}

/// Takes a set of instructions that this processor and this build have.
void use_instructions(cpu::Instructions instructions, MachineOptions& options) {
  const std::vector<cpu::Instructions> available = cpu::available_instructions();
  if (!std::ranges::count(available, instructions)) {
    throw InputError(
        fmt::format("--instructions: found \"{}\", which this processor, or this build, does not have; "
                    "expected one of {}",
                    name_of(instructions), cpu::names_of(available)));
  }
  options.instructions = instructions;
}

void declare_instructions(CLI::App& app, MachineOptions& options) {
  add_choice<cpu::Instructions>(
      app, "--instructions", [&](cpu::Instructions instructions) { use_instructions(instructions, options); },
      "What stages of the CPU backend are built for; the widest of this machine if not given, results do not "
      "depend on it. ");
}

void declare_threads(CLI::App& app, MachineOptions& options) {
  options.threads = cpu::hardware_threads();
  add_number<int>(
      app, "--threads", "1 to 1024", [](int threads) { return threads >= 1 && threads <= 1024; },
      [&](int threads) { options.threads = threads; },
      "Threads of the CPU backend; results do not depend on it")
      ->type_name("N");
}

void declare_cpu_options(CLI::App& app, MachineOptions& options) {
  declare_threads(app, options);
  declare_instructions(app, options);
}

void declare_machine(CLI::App& app, MachineOptions& options) {
  add_choice<BackendChoice>(
      app, "--backend", [&](BackendChoice backend) { options.backend = backend; },
      "Where to compute; auto if not given. ");
  add_choice<Precision>(
      app, "--precision", [&](Precision precision) { options.precision = precision; },
      "float if not given. ");
  declare_cpu_options(app, options);
}

void declare_shader_dir(CLI::App& app, MachineOptions& options) {
  add_path(app, "--shader-dir", options.shader_dir,
           "Take shaders from this folder, laid out as shaders/, where it has them")
      ->type_name("DIR")
      ->group("OpenGL");
}

void declare_gl_options(CLI::App& app, MachineOptions& options) {
  add_number<int>(
      app, "--gl-device", "a number that `sluice info` lists", [](int device) { return device >= 0; },
      [&](int device) { options.gl_device = device; },
      "Compute and draw on EGL device N; `sluice info` lists them")
      ->type_name("N")
      ->group("OpenGL");
  declare_shader_dir(app, options);
}

void declare_agree_options(CLI::App& app, AgreeOptions& options) {
  declare_scene(app, options.scene, options.overrides);
  declare_cpu_options(app, options.machine);
  declare_gl_options(app, options.machine);
  add_number<uint64_t>(
      app, "--steps", "a whole number from 1 on", [](uint64_t steps) { return steps > 0; },
      [&](uint64_t count) { options.steps = count; }, "Steps to run on both; 200 if not given")
      ->type_name("N");
  app.add_option(
         "--split", options.split,
         "Run each step on the CPU up to this stage and on the GPU after it, instead of all on the GPU")
      ->type_name("STAGE");
  auto* summary =
      add_path(app, "--summary", options.summary, "Write the table as JSON")->type_name("FILE.json");
  auto* stage = app.add_option("--stage", options.stage, "Compare this stage alone, in every step")
                    ->type_name("STAGE")
                    ->excludes("--split")
                    ->excludes(summary);
  add_fields(app, options.dump,
             "Print what both have in these fields after the last run of the stage, as CSV")
      ->needs(stage);
}

void declare_run_options(CLI::App& app, RunOptions& options) {
  app.add_option("SCENE", options.scene, scene_help);  // whether there has to be one is not known here
  declare_overrides(app, options.overrides);
  declare_machine(app, options.machine);
  declare_gl_options(app, options.machine);
  add_steps_and_time(app, options.steps, options.time, "in place of time.duration");
  add_output_options(app, options);
  add_path(app, "--record", options.frames.record, "Write a recording, for `sluice play` and `sluice export`")
      ->type_name("FILE")
      ->group("Output");
  add_fps(app, options.overrides);
  add_frame_outputs(app, options.overrides, options.frames);
  add_checkpoint_options(app, options);
}

void declare_study_options(CLI::App& app, StudyOptions& options) {
  app.add_option("NAME", options.name, "Which table; without one they are listed");
  add_path(app, "--out", options.out, "Write the tables, and what they are made of, into this folder")
      ->type_name("DIR");
  app.add_flag("--quick", options.quick, "Only a part, which takes a minute at most");
  app.add_option("--only", options.only, "Only cases or points whose name has this text in it")
      ->type_name("TEXT");
  app.add_flag("--list", options.list, "Print the `sluice run` of each case, one per line, and run nothing");
  add_path(app, "--collect", options.collect,
           "Run nothing: make the tables of what results of the lines of --list are in this folder")
      ->type_name("DIR");
  add_number<int>(
      app, "--jobs", "1 to 1024", [](int jobs) { return jobs >= 1 && jobs <= 1024; },
      [&](int jobs) { options.jobs = jobs; }, "Cases to run at a time; 1 if not given")
      ->type_name("N");
}

void declare_export_options(CLI::App& app, ExportOptions& options) {
  app.add_option("RECORDING", options.recording, "A file made by `sluice run --record`")->required();
  add_frame_outputs(app, options.overrides, options.frames);
  declare_gl_options(app, options.machine);
  app.add_flag("--quiet", options.quiet, "Say nothing")->group("Output");
}

void declare_play_options(CLI::App& app, PlayOptions& options) {
  app.add_option(
      "SOURCE", options.source,
      "A scene file, the name of a shipped scene, or a recording; without one the shipped scenes are shown");
  declare_overrides(app, options.overrides);
  declare_machine(app, options.machine);
  declare_shader_dir(app, options.machine);
  add_steps_and_time(app, options.steps, options.time, "before the window pauses");
  add_picture_options(app, options.overrides, options.overlay, "Text in the window; all if not given. ");
  add_speed(app, options.speed, "Simulated seconds per second, where the machine keeps up; 1 if not given");
}

}  // namespace

int fail(int code, const std::string& message) {
  std::fputs(fmt::format("sluice: {}\n", message).c_str(), stderr);  // may be closed, too, and must not throw
  return code;
}

RunOptions run_options_of(std::vector<std::string> words) {
  CLI::App app;
  RunOptions options;
  declare_run_options(app, options);
  std::ranges::reverse(words);  // as this library wants them
  app.parse(words);
  return options;
}

int run_command_line(int argc, char** argv) {
  CLI::App app{
      "SPH fluids in two dimensions: pressure from a state equation against pressure from a linear system."};
  app.require_subcommand(0, 1);  // none is refused below, so that an unknown one is named
  const std::string of_commit = commit().empty() ? "" : fmt::format(" (commit {})", commit());
  app.set_version_flag("--version", fmt::format("sluice {}{}", version(), of_commit));
  app.footer("Start with: sluice run breaking_dam --frames frames");

  RunOptions options;
  auto* run = app.add_subcommand("run", "Simulate a scene");
  declare_run_options(*run, options);

  AgreeOptions comparison;
  auto* agree = app.add_subcommand("agree", "Compare the GPU with the CPU, stage by stage and over a run");
  declare_agree_options(*agree, comparison);

  bool keys = false;
  auto* scenes = app.add_subcommand("scenes", "List the shipped scenes");
  scenes->add_flag("--keys", keys, "Print the reference of all keys of a scene file, as Markdown");

  std::optional<std::string> scene;
  auto* information = app.add_subcommand("info", "Show what this machine offers, or how a scene is run");
  auto* shown = information->add_option("SCENE", scene, "A scene file, or the name of a shipped scene");
  std::vector<std::string> changes;
  declare_overrides(*information, changes);
  information->get_option("--set")->needs(shown);
  std::optional<std::string> shader;
  auto* shows_shader =
      information
          ->add_option("--shader", shader, "Print the GLSL of this stage as it is compiled for the scene")
          ->type_name("STAGE")
          ->needs(shown);
  MachineOptions shown_on;
  declare_shader_dir(*information, shown_on);
  information->get_option("--shader-dir")->needs(shows_shader);

  PlayOptions playing;
  auto* play = app.add_subcommand("play", "Watch a scene or a recording in a window");
  declare_play_options(*play, playing);

  ExportOptions exporting;
  auto* from_recording =
      app.add_subcommand("export", "Make pictures, a film or ParaView files from a recording");
  declare_export_options(*from_recording, exporting);

  StudyOptions studying;
  auto* study = app.add_subcommand("study", "Run a table of runs; without a name the studies are listed");
  declare_study_options(*study, studying);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    return fail(bad_input,
                fmt::format("{}\nsluice: run `sluice --help` or `sluice COMMAND --help`", error.what()));
  }
  if (app.get_subcommands().empty()) {
    return fail(bad_input,
                "found no subcommand, expected run, play, export, agree, study, scenes or info\nsluice: run "
                "`sluice --help`");
  }
  if (run->parsed()) return run_command(options);
  if (play->parsed()) return play_command(playing);
  if (from_recording->parsed()) return export_command(exporting);
  if (agree->parsed()) return agree_command(comparison);
  if (study->parsed()) return study_command(studying);
  if (scenes->parsed()) return scenes_command(keys);
  return shader ? shader_command(*scene, changes, *shader, shown_on.shader_dir)
                : info_command(scene, changes);
}

}  // namespace sluice::app
