// `sluice study`: whole tables of runs, by name.
#include <fmt/format.h>

#include <algorithm>

#include "apps/sluice/commands.hpp"
#include "apps/sluice/study_hard.hpp"
#include "apps/sluice/study_points.hpp"
#include "sluice/error.hpp"

namespace sluice::app {
namespace {

constexpr const char* hard = "hard";

std::string known_studies() {
  std::string text = fmt::format("\n  {:<12}hard cases, and what has to come of them", hard);
  for (const Study& study : studies()) text += fmt::format("\n  {:<12}{}", study.name, study.what);
  return text;
}

}  // namespace

int study_command(const StudyOptions& options) {
  const auto study = std::ranges::find(studies(), options.name, &Study::name);
  if (options.name != hard && study == studies().end()) {
    throw InputError(fmt::format("study: found {}, expected one of these:{}",
                                 options.name.empty() ? "no name" : fmt::format("\"{}\"", options.name),
                                 known_studies()));
  }
  if (options.list && options.collect)
    throw InputError("--collect: found --list beside it, expected one of the two");
  if (options.name == hard && options.collect) {
    throw InputError(
        "--collect: found the study hard, expected another; its cases are judged by the process that runs "
        "them, so run `sluice study hard --out DIR`");
  }
  if (!options.out && !options.collect) {
    throw InputError(fmt::format("study {}: found no --out, expected a folder for its tables", options.name));
  }
  return options.name == hard ? study_hard(options) : study_points(*study, options);
}

}  // namespace sluice::app
