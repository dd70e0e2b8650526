// `sluice`: parses the command line and turns errors into messages and exit codes: 0 done, 1 invalid run, 2
// bad input or usage, 3 the environment failed.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <new>

#include "apps/sluice/commands.hpp"
#include "core/error.hpp"
#include "core/summary.hpp"

namespace {

constexpr int bad_input = 2, environment_failed = 3;

int fail(int code, const std::string& message) {
  std::fputs(fmt::format("sluice: {}\n", message).c_str(), stderr);  // may be closed, too, and must not throw
  return code;
}

/// Threads that wait for each other spin before they sleep, by default so long that another busy program
/// makes small scenes a hundred times slower. The OpenMP runtime reads how long only when a program starts,
/// so this one starts again, once; if it can't, it goes on as it is.
void limit_spinning(char** argv) {
  if (std::getenv("GOMP_SPINCOUNT") != nullptr || std::getenv("OMP_WAIT_POLICY") != nullptr) return;
  setenv("GOMP_SPINCOUNT", "5000", 1);
  execv("/proc/self/exe", argv);
}

int dispatch(int argc, char** argv) {
  CLI::App app{
      "SPH fluids in two dimensions: pressure from a state equation against pressure from a linear system."};
  app.require_subcommand(0, 1);  // none is refused below, so that an unknown one is named
  app.set_version_flag("--version", "sluice " + sluice::version());
  app.footer("Start with: sluice run breaking_dam --frames frames");

  sluice::RunOptions options;
  auto* run = app.add_subcommand("run", "Simulate a scene");
  sluice::declare_run_options(*run, options);

  sluice::AgreeOptions comparison;
  auto* agree = app.add_subcommand("agree", "Compare the GPU with the CPU, stage by stage and over a run");
  sluice::declare_agree_options(*agree, comparison);

  bool keys = false;
  auto* scenes = app.add_subcommand("scenes", "List the shipped scenes");
  scenes->add_flag("--keys", keys, "Print the reference of all keys of a scene file, as Markdown");

  std::optional<std::string> scene;
  auto* information = app.add_subcommand("info", "Show what this machine offers, or how a scene is run");
  auto* shown = information->add_option("SCENE", scene, "A scene file, or the name of a shipped scene");
  std::vector<std::string> changes;
  sluice::declare_overrides(*information, changes);
  information->get_option("--set")->needs(shown);

  sluice::PlayOptions playing;
  auto* play = app.add_subcommand("play", "Watch a scene or a recording in a window");
  sluice::declare_play_options(*play, playing);

  sluice::ExportOptions exporting;
  auto* from_recording =
      app.add_subcommand("export", "Make pictures, a film or ParaView files from a recording");
  sluice::declare_export_options(*from_recording, exporting);

  sluice::StudyOptions studying;
  auto* study = app.add_subcommand("study", "Run a table of runs; without a name the studies are listed");
  sluice::declare_study_options(*study, studying);

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
  if (run->parsed()) return sluice::run_command(options);
  if (play->parsed()) return sluice::play_command(playing);
  if (from_recording->parsed()) return sluice::export_command(exporting);
  if (agree->parsed()) return sluice::agree_command(comparison);
  if (study->parsed()) return sluice::study_command(studying);
  if (scenes->parsed()) return sluice::scenes_command(keys);
  return sluice::info_command(scene, changes);
}

}  // namespace

int main(int argc, char** argv) {
  limit_spinning(argv);
  // A reader that goes away and a file beyond its limit are failed writes, not deaths.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  int code = 0;
  try {
    code = dispatch(argc, argv);
  } catch (const sluice::InputError& error) {
    return fail(bad_input, error.what());
  } catch (const std::bad_alloc&) {
    return fail(environment_failed, "out of memory; close other programs or use fewer particles");
  } catch (const std::exception& error) {
    return fail(environment_failed, error.what());
  }
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    return fail(environment_failed, "standard output could not be written");
  }
  return code;
}
