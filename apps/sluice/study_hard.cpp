// Every case in a process of its own; then the table.
#include "apps/sluice/study_hard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "apps/sluice/children.hpp"
#include "core/output/output_file.hpp"
#include "cpu/backend.hpp"
#include "gpu/backend.hpp"
#include "gpu/context.hpp"
#include "sluice/error.hpp"
#include "studies/hard_table.hpp"
#include "studies/table.hpp"

namespace sluice::app {

using namespace study;
namespace {

constexpr const char* backends[] = {"cpu", "gpu"};

using Row = std::vector<std::string>;

std::filesystem::path scene_path(const StudyOptions& options, const HardCase& hard) {
  return *options.out / "scenes" / fmt::format("{}.toml", hard.name);
}

std::vector<HardCase> cases_of(const StudyOptions& options) {
  std::vector<HardCase> cases = hard_cases();
  std::erase_if(cases, [&](const HardCase& hard) {
    return hard.name.find(options.only) == std::string::npos || (options.quick && !hard.quick);
  });
  if (cases.empty()) {
    throw InputError(
        fmt::format("--only: found \"{}\", expected text from the name of a {}case; --list prints them",
                    options.only, options.quick ? "quick " : ""));
  }
  return cases;
}

void write_scenes(const StudyOptions& options, const std::vector<HardCase>& cases) {
  std::error_code error;
  std::filesystem::create_directories(*options.out / "scenes", error);
  if (error) {
    throw EnvironmentError(fmt::format("{}: the folder can't be created: {}; choose another for --out",
                                       options.out->string(), error.message()));
  }
  for (const HardCase& hard : cases) {
    const char* note =
        hard.rearrange
            ? "# The study moves particles of this scene before it runs it; by itself it is another.\n\n"
            : "";
    write_file(scene_path(options, hard), note + hard.scene);
  }
}

void list(const StudyOptions& options, const std::vector<HardCase>& cases) {
  for (const HardCase& hard : cases) {
    if (hard.rearrange) {
      fmt::print("# {}: rearranged, runs only in the study\n", hard.name);
      continue;
    }
    for (const char* backend : backends) {
      fmt::print("sluice run {} --backend {} --precision float --quiet --summary {}\n",
                 scene_path(options, hard).string(), backend,
                 (*options.out / fmt::format("{}_{}.json", hard.name, backend)).string());
    }
  }
}

/// Name of the OpenGL renderer, asked in a process of its own, since one that has OpenGL may not have
/// children.
std::string renderer() {
  std::string found;
  const auto task = [](size_t) { return gpu::Context().renderer(); };
  in_children(1, 1, task, [&](size_t, const ChildEnd& end) {
    if (end.signal != 0) throw EnvironmentError(fmt::format("OpenGL ended with signal {}", end.signal));
    if (end.code != 0) throw EnvironmentError(fmt::format("study: needs OpenGL, too: {}", end.text));
    found = end.text;
  });
  return found;
}

CaseResult run_on(const HardCase& hard, bool on_gpu, int threads) {
  if (!on_gpu) return run_case(hard, *cpu::make_backend(Precision::single_, threads));
  gpu::suit_software_threads(0);
  const gpu::Context context;
  return run_case(hard, *gpu::make_backend(context));
}

/// A row per case and backend, in their order.
std::vector<Row> run_all(const StudyOptions& options, const std::vector<HardCase>& cases) {
  const size_t count = 2 * cases.size();
  std::vector<Row> rows(count);
  const int threads = std::max(1, cpu::hardware_threads() / options.jobs);
  const auto task = [&](size_t i) {
    const HardCase& hard = cases[i / 2];
    const Row row = hard_row(hard, run_on(hard, i % 2 == 1, threads));
    return nlohmann::json(row).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  };
  size_t ended = 0;
  in_children(count, options.jobs, task, [&](size_t i, const ChildEnd& end) {
    const HardCase& hard = cases[i / 2];
    const char* backend = backends[i % 2];
    if (end.signal != 0) {
      rows[i] = hard_row_without(hard, backend, fmt::format("crashed with signal {}", end.signal));
    } else if (end.code != 0) {
      rows[i] = hard_row_without(hard, backend, fmt::format("failed: {}", end.text));
    } else {
      rows[i] = nlohmann::json::parse(end.text).get<Row>();
    }
    fmt::print(stderr, "{:>4}/{} {:6.1f} s  {} on {}: {}\n", ++ended, count, end.seconds, hard.name, backend,
               rows[i].back());
  });
  return rows;
}

/// How many cases left the same state on both backends.
size_t count_equal(const std::vector<Row>& rows) {
  const size_t state = place_of("state", hard_columns());
  size_t equal = 0;
  for (size_t i = 0; i < rows.size(); i += 2) equal += rows[i][state] == rows[i + 1][state] ? 1 : 0;
  return equal;
}

}  // namespace

int study_hard(const StudyOptions& options) {
  const std::vector<HardCase> cases = cases_of(options);
  if (options.list) {
    write_scenes(options, cases);
    list(options, cases);
    return 0;
  }
  const std::string device = renderer();
  write_scenes(options, cases);
  const TextTable table{hard_columns(), run_all(options, cases)};
  const size_t equal = count_equal(table.rows);
  const std::string page =
      fmt::format("{}\n{} cases on the CPU and on {}; {} of them end in the same bits on both.\n",
                  table.only(hard_page_columns()).markdown(), cases.size(), device, equal);
  write_file(*options.out / "hard.csv", table.csv());
  write_file(*options.out / "hard.md", page);
  fmt::print("{}", page);
  int code = 0;
  for (const Row& row : table.rows) {
    if (is_as_expected(row)) continue;
    fmt::print(stderr, "sluice: {} on {} did not come out as expected: {}\n", row[0], row[2], row.back());
    code = 1;
  }
  return code;
}

}  // namespace sluice::app
