// Words and tables of the page.
#include "bench/gpu_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "bench/tables.hpp"
#include "core/text.hpp"

namespace sluice::bench {
namespace {

constexpr std::string_view method_text = R"(
## How it is measured

- The scene is `breaking_dam`, refined to about the given number of fluid particles, with viscosity 2, time step 0.005 h
  (SSPH 0.001 h); for WCSPH `wcsph_box` with time step 0.02 h; and a start displaced by up to 0.1 h, after ten steps:
  particles are no longer on a lattice.
- Whole steps run, with a fixed number of sweeps; every repetition is the same few steps again. A step is timed by the
  wall clock, with everything that the simulator reads back. A stage is timed in these steps by the backend itself: by
  timestamps on the device, or, where a processor plays the graphics card, by the clock after waiting for the stage to
  end. Where a device waits for commands in the middle of a stage, as it may at small sizes, that counts. What is left of
  a step is the processor's own work, reading back, and what a device waits between stages.
- A sweep is `pressure_acceleration`, `pressure_operator`, `residual`, `stop_test` and `pressure_update`.
- The bytes of a sweep are those it must move at the least, by the stage table (`core/model/stages.hpp`): every field that one
  of its stages reads or writes counts once per stage, with 4 bytes for a float or an index and 8 for a vector. The
  neighbour list counts with the entries that are in it, 4 bytes of index and 8 of gradient each, in both stages that walk
  it. What caches save beyond that, scratch memory and the parts of slices that hold no neighbour do not count.
- Copy bandwidth counts bytes read and bytes written, of `glCopyBufferSubData` between two buffers on the same device.
- Tables hold the fastest of the repetitions, each number on its own. Ratios are of speeds: 2 is twice as fast.
)";

constexpr std::string_view software_text =
    "- The driver uses all its threads at every size. `sluice run` lets it use only the one that calls it "
    "below 20,000 "
    "particles.\n";

const SizeTimes* beside_cpu(const GpuReport& report) {
  for (const SizeTimes& times : report.sizes) {
    if (times.size == report.cpu.size && !times.steps.empty()) return &times;
  }
  return nullptr;
}

/// `cell` of every size.
template <class Cell>
std::vector<std::string> size_cells(const GpuReport& report, Cell&& cell) {
  std::vector<std::string> cells;
  for (const SizeTimes& times : report.sizes) {
    cells.push_back(times.left_out.empty() ? cell(times) : "left out");
  }
  return cells;
}

/// What a row says of the GPU and the CPU beside each other.
enum class Compare { nothing, more_is_faster, less_is_faster };

/// A row with `value` of every size and of the CPU, and how many times as fast the GPU is at the CPU's size.
template <class Value>
std::string compared_row(const std::string& title, const GpuReport& report, Compare compare, Value&& value) {
  auto cells = size_cells(report, [&](const SizeTimes& times) { return number_text(value(times)); });
  const double cpu = value(report.cpu);
  const SizeTimes* gpu = beside_cpu(report);
  double ratio = std::nan("");
  if (gpu != nullptr && compare == Compare::more_is_faster) ratio = value(*gpu) / cpu;
  if (gpu != nullptr && compare == Compare::less_is_faster) ratio = cpu / value(*gpu);
  cells.push_back(number_text(cpu));
  cells.push_back(number_text(ratio));
  return table_row(title, cells);
}

std::vector<std::string> names(const GpuReport& report, bool with_cpu) {
  std::vector<std::string> all;
  for (const SizeTimes& times : report.sizes) all.push_back(size_text(times.size));
  if (with_cpu) {
    all.push_back(fmt::format("CPU, {} threads, {}", report.threads, size_text(report.cpu.size)));
    all.push_back("GPU / CPU");
  }
  return all;
}

std::string left_out(const GpuReport& report) {
  std::string text;
  for (const SizeTimes& times : report.sizes) {
    if (!times.left_out.empty())
      text += fmt::format("\n{} left out: {}\n", size_text(times.size), times.left_out);
  }
  return text;
}

std::string sweep_table(const GpuReport& report) {
  std::string text = "\n### Sweeps\n\n" + table_head("", names(report, false));
  const auto add = [&](const std::string& title, auto value) {
    text += table_row(title, size_cells(report, [&](const SizeTimes& times) {
                        return number_text(value(times.steps.at(PressureMethod::iisph)));
                      }));
  };
  const auto rate = [](const StepTimes& times) { return times.sweep_bytes / times.sweep; };
  text += table_row("fluid particles", size_cells(report, [](const SizeTimes& times) {
                      return std::to_string(times.steps.at(PressureMethod::iisph).n);
                    }));
  add("neighbours per particle", [](const StepTimes& times) { return times.neighbours; });
  add("nanoseconds per particle", [](const StepTimes& times) { return 1e9 * times.sweep / times.n; });
  add("millions of particles per second",
      [](const StepTimes& times) { return 1e-6 * times.n / times.sweep; });
  add("bytes per particle", [](const StepTimes& times) { return times.sweep_bytes / times.n; });
  add("GB/s", [&](const StepTimes& times) { return 1e-9 * rate(times); });
  add("share of copy bandwidth, %", [&](const StepTimes& times) { return 100 * rate(times) / report.copy; });
  return text + left_out(report);
}

std::string step_table(const GpuReport& report) {
  std::string text = fmt::format("\n### Whole steps (IISPH: {} sweeps)\n\n", sweeps_per_step) +
                     table_head("", names(report, true));
  for (const PressureMethod method : methods) {
    const auto steps = [&](const SizeTimes& times) -> const StepTimes& { return times.steps.at(method); };
    const std::string title(title_of(method));
    text += compared_row(title + ", steps per second", report, Compare::more_is_faster,
                         [&](const SizeTimes& times) { return 1 / steps(times).step; });
    text += compared_row(title + ", millions of particles per second", report, Compare::more_is_faster,
                         [&](const SizeTimes& times) { return 1e-6 * steps(times).n / steps(times).step; });
    text += compared_row(
        title + ", time in stages, %", report, Compare::nothing,
        [&](const SizeTimes& times) { return 100 * steps(times).in_stages / steps(times).step; });
  }
  return text;
}

std::string stage_table_text(const GpuReport& report) {
  std::string text = "\n### Stages, nanoseconds per particle\n\n" + table_head("stage", names(report, true));
  for (size_t i = 0; i < stage_count; ++i) {
    const Stage stage = static_cast<Stage>(i);
    if (!info(stage).tasks.has(Task::step) || runs_once(stage)) continue;  // of the start only
    const PressureMethod method = timed_with(stage);
    text += compared_row(std::string(info(stage).name), report, Compare::less_is_faster,
                         [&](const SizeTimes& times) {
                           const StepTimes& from = times.steps.at(method);
                           return 1e9 * from.stage[i] / from.n;
                         });
  }
  return text;
}

std::string compared_table(const GpuReport& report) {
  std::string text = fmt::format(
      "\n### A sweep beside the CPU backend and the yardstick, milliseconds per sweep by the wall clock\n\n"
      "Measured in turns in one run, {} sweeps at a time, with reading back whether the solve is over. 74k "
      "is "
      "`breaking_dam` with `particles.spacing=0.8 viscosity.coefficient=2 time.dt=0.004`, displaced as "
      "above. The "
      "yardstick (`bench/yardstick.cpp`) is a sweep as a straightforward programmer would write it, on one "
      "thread.\n\n",
      sweeps_per_step);
  text += table_head("fluid particles", {"yardstick", fmt::format("CPU, {} threads", report.threads), "GPU",
                                         "CPU / yardstick", "GPU / yardstick", "GPU / CPU"});
  for (const SweepTimes& times : report.compared) {
    std::vector<std::string> cells;
    for (const double seconds : {times.yardstick, times.cpu, times.gpu})
      cells.push_back(number_text(1e3 * seconds));
    for (const double ratio :
         {times.yardstick / times.cpu, times.yardstick / times.gpu, times.cpu / times.gpu})
      cells.push_back(number_text(ratio));
    text += table_row(std::to_string(times.n), cells);
  }
  return text;
}

std::string switch_table(const GpuReport& report) {
  std::string text =
      fmt::format("\n### Where `--backend auto` should switch: whole IISPH steps, {} sweeps, per second\n\n",
                  sweeps_per_step);
  text += table_head("fluid particles", {fmt::format("CPU, {} threads", report.threads), "GPU", "GPU / CPU"});
  for (const StepPair& pair : report.small) {
    text += table_row(std::to_string(pair.n), {number_text(1 / pair.cpu), number_text(1 / pair.gpu),
                                               number_text(pair.cpu / pair.gpu)});
  }
  const std::optional<uint32_t> from = faster_from(report.small);
  return text + (from ? fmt::format("\nThe GPU is faster from {} particles on.\n", *from)
                      : "\nThe CPU is faster at the largest of these.\n");
}

}  // namespace

std::optional<uint32_t> faster_from(const std::vector<StepPair>& sizes) {
  std::optional<uint32_t> from;
  for (const StepPair& pair : sizes) {
    if (pair.gpu >= pair.cpu)
      from.reset();
    else if (!from)
      from = pair.n;
  }
  return from;
}

std::string short_name(const std::string& renderer) {
  return renderer.substr(0, std::min(renderer.find(" ("), renderer.find('/')));
}

std::string page_name(const std::string& renderer) {
  std::string name;
  for (const char c : short_name(renderer)) {
    if (std::isalnum(static_cast<unsigned char>(c)))
      name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    else if (!name.empty() && name.back() != '-')
      name += '-';
  }
  while (name.ends_with('-')) name.pop_back();
  return (name.empty() ? "unknown" : name) + ".md";
}

std::string gpu_page(const GpuReport& report) {
  std::string page = fmt::format(
      "# Speed of the GPU backend on {}\n\n`scripts/bench_gpu` installs what is missing, builds, tests, "
      "measures and "
      "writes this page.\n\n- GPU: {}{}\n- driver: OpenGL {}\n- date: {}\n- processor: {}, {} hardware "
      "threads\n"
      "- compiler: {}\n- copy bandwidth: {} GB/s, with {:.0f} MiB in each buffer\n",
      short_name(report.renderer), report.renderer,
      report.software ? " (a processor plays the graphics card)" : "", report.driver, report.date,
      report.processor, report.threads, report.compiler, number_text(1e-9 * report.copy),
      report.bytes / (1024 * 1024));
  page += others_text(report.others);
  if (report.tests) page += "\n## Tests\n\n" + report.tests->markdown;
  if (report.agreement)
    page += "\n## Agreement with the CPU backend in float\n\n" + report.agreement->markdown;
  page += method_text;
  if (report.software) page += software_text;
  page += "\n## Measured\n" + sweep_table(report) + step_table(report) + stage_table_text(report) +
          compared_table(report) + switch_table(report);
  return page;
}

}  // namespace sluice::bench
