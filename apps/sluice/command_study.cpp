// `sluice study`: whole tables of runs, by name.
#include <fmt/format.h>

#include "apps/sluice/commands.hpp"
#include "apps/sluice/study_hard.hpp"
#include "core/error.hpp"

namespace sluice {
namespace {

struct Study {
  const char *name, *what;
  int (*run)(const StudyOptions&);
};

constexpr Study studies[] = {{"hard", "hard cases, and what has to come of them", study_hard}};

std::string known_studies() {
  std::string text;
  for (const Study& study : studies) text += fmt::format("\n  {:<12}{}", study.name, study.what);
  return text;
}

}  // namespace

int study_command(const StudyOptions& options) {
  for (const Study& study : studies) {
    if (options.name != study.name) continue;
    if (!options.out)
      throw InputError(fmt::format("study {}: found no --out, expected a folder for its tables", study.name));
    return study.run(options);
  }
  throw InputError(fmt::format("study: found {}, expected one of these:{}",
                               options.name.empty() ? "no name" : fmt::format("\"{}\"", options.name),
                               known_studies()));
}

}  // namespace sluice
