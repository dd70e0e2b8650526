// The command line: the options of each subcommand as a value.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cpu/backend.hpp"
#include "sluice/choices.hpp"

namespace sluice::app {

// clang-format off
#define SLUICE_BACKEND_CHOICES(CHOICE)                                          \
  CHOICE(automatic, "auto", "a graphics card if there is one and enough to do, else the CPU")    \
  CHOICE(cpu, "cpu", "this processor")                                          \
  CHOICE(gpu, "gpu", "OpenGL compute shaders")
SLUICE_DECLARE_CHOICES(BackendChoice, SLUICE_BACKEND_CHOICES)

#define SLUICE_OVERLAY_CHOICES(CHOICE)                                          \
  CHOICE(none, "none", "no text")                                               \
  CHOICE(facts, "facts", "title, method, time, iterations and particles")       \
  CHOICE(all, "all", "these and milliseconds per step")
SLUICE_DECLARE_CHOICES(OverlayChoice, SLUICE_OVERLAY_CHOICES)
// clang-format on

/// Options of where to compute and draw.
struct MachineOptions {
  BackendChoice backend = BackendChoice::automatic;
  Precision precision = Precision::single_;
  int threads = 1;
  std::optional<cpu::Instructions> instructions;  ///< the widest if not given
  std::optional<int> gl_device;
  std::optional<std::filesystem::path> shader_dir;
  bool time_stages = false;  ///< whether somebody asks how long each stage took
};

/// Options of what is made of the frames of a run, or of a recording of it.
struct FrameOptions {
  std::optional<std::filesystem::path> frames, video, vtk, record;
  OverlayChoice overlay = OverlayChoice::facts;
  double speed = 1;  ///< simulated seconds per second of a film

  bool any() const { return frames || video || vtk || record; }
  bool pictures() const { return frames || video; }
};

struct RunOptions {
  std::optional<std::string> scene;    ///< none: that of the checkpoint
  std::vector<std::string> overrides;  ///< KEY=VALUE, those of --fps, --size and --colour included
  MachineOptions machine;
  std::optional<uint64_t> steps;
  std::optional<double> time;
  std::optional<std::filesystem::path> state, series, summary, sweeps, probes, wall_forces;
  std::vector<std::string> dump;  ///< fields whose values the state has too
  std::optional<std::filesystem::path> checkpoint, resume, start_from;
  std::optional<double> checkpoint_every;  ///< in the scene's time
  FrameOptions frames;
  bool quiet = false;
};

struct ExportOptions {
  std::string recording;
  std::vector<std::string> overrides;  ///< KEY=VALUE, of --size and --colour
  MachineOptions machine;              ///< what of it concerns OpenGL
  FrameOptions frames;
  bool quiet = false;
};

struct PlayOptions {
  std::string source;                  ///< a scene or a recording; empty for the list of scenes
  std::vector<std::string> overrides;  ///< KEY=VALUE, as in RunOptions
  MachineOptions machine;
  std::optional<uint64_t> steps;
  std::optional<double> time;
  OverlayChoice overlay = OverlayChoice::all;
  double speed = 1;
};

struct AgreeOptions {
  std::string scene;
  std::vector<std::string> overrides;
  MachineOptions machine;  ///< of the CPU; its backend and precision are not asked for
  uint64_t steps = 200;
  std::optional<std::string> split;
  std::optional<std::string> stage;  ///< the only one to compare
  std::vector<std::string> dump;     ///< fields whose values it prints
  std::optional<std::filesystem::path> summary;
};

struct StudyOptions {
  std::string name;
  std::optional<std::filesystem::path> out, collect;
  std::string only;    ///< part of the names of the cases to run
  int jobs = 1;        ///< cases at a time
  bool quick = false;  ///< only some of them
  bool list = false;   ///< print the runs instead
};

}  // namespace sluice::app
