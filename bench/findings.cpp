// Reads what ctest and `sluice agree` wrote.
#include "bench/findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "bench/tables.hpp"

namespace sluice::bench {
namespace {

using nlohmann::json;

struct Agreement {
  std::string name;  ///< of the file
  json content;
};

/// Never rounded up to all of them.
std::string share_text(double share) { return fmt::format("{:g} %", std::floor(1e5 * share) / 1e3); }

/// JSON has no number for what is not finite.
std::string value_text(const json& value) { return value.is_number() ? value.dump() : "not finite"; }

std::string marked(const std::string& text, bool good) { return good ? text : "**" + text + "**"; }

std::string run_row(const Agreement& agreement) {
  const json& content = agreement.content;
  const json& run = content.at("run");
  const bool equal = run.at("equal").get<bool>(), pass = content.at("pass").get<bool>(),
             itself = content.at("gpu_with_itself").at("equal").get<bool>();
  return table_row(
      agreement.name,
      {content.at("steps").dump(),
       equal ? "equal bit for bit"
             : fmt::format("differs from step {} on", run.at("first_difference_step").dump()),
       value_text(run.at("max_dx_over_h")), run.at("iterations_equal").get<bool>() ? "yes" : "no",
       marked(itself ? "equal" : "DIFFERS", itself), marked(pass ? "agrees" : "DISAGREES", pass)});
}

/// "2 ulp, 99.9 %", or a dash for a stage that the scene does without.
std::string stage_cell(const json& stages, const std::string& name) {
  for (const json& stage : stages) {
    if (stage.at("name") != name) continue;
    return marked(fmt::format("{} ulp, {}", value_text(stage.at("max_ulp")),
                              share_text(stage.at("equal_share").get<double>())),
                  stage.at("pass").get<bool>());
  }
  return "-";
}

std::vector<std::string> stage_names(const std::vector<Agreement>& agreements) {
  std::vector<std::string> names;
  for (const Agreement& agreement : agreements) {
    for (const json& stage : agreement.content.at("stages")) {
      const std::string name = stage.at("name").get<std::string>();
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
  }
  return names;
}

std::string tables(const std::vector<Agreement>& agreements) {
  std::string text = table_head("run", {"steps", "state at the end", "largest distance / h", "same sweeps",
                                        "beside itself", "verdict"});
  std::vector<std::string> titles;
  for (const Agreement& agreement : agreements) {
    text += run_row(agreement);
    titles.push_back(agreement.name);
  }
  text +=
      "\nEach stage on the same input: largest difference in units in the last place, share of values that "
      "are "
      "equal bit for bit.\n\n" +
      table_head("stage", titles);
  for (const std::string& name : stage_names(agreements)) {
    std::vector<std::string> cells;
    for (const Agreement& agreement : agreements) {
      cells.push_back(stage_cell(agreement.content.at("stages"), name));
    }
    text += table_row(name, cells);
  }
  return text;
}

}  // namespace

Finding read_test_log(const std::filesystem::path& log) {
  std::ifstream file(log);
  Finding finding;
  bool listing = false;
  for (std::string line; std::getline(file, line);) {
    if (line.find("% tests passed") != std::string::npos) {
      finding.good = line.starts_with("100%");
      finding.markdown = marked(line, finding.good) + "\n";
    } else if (line.find("tests FAILED:") != std::string::npos) {
      finding.good = false;
      finding.markdown += "\n";
      listing = true;
    } else if (listing) {
      listing = line.starts_with("\t");
      if (listing) finding.markdown += "- " + line.substr(line.find_first_not_of("\t ")) + "\n";
    }
  }
  if (!finding.markdown.empty()) return finding;
  return {false, "**The test suite did not come to its end.**\n"};
}

Finding read_agreement(const std::vector<std::filesystem::path>& files) {
  bool good = true;
  std::string problems;
  std::vector<Agreement> agreements;
  for (const std::filesystem::path& path : files) {
    const std::string name = path.stem().string();
    try {
      std::ifstream file(path);
      const Agreement agreement{name, json::parse(file)};
      tables({agreement});  // throws when something is missing
      good = good && agreement.content.at("pass").get<bool>();
      agreements.push_back(agreement);
    } catch (const json::exception&) {
      good = false;
      problems += fmt::format("**{}: no result, see what `sluice agree` said.**\n\n", name);
    }
  }
  return {good, problems + (agreements.empty() ? "" : tables(agreements))};
}

}  // namespace sluice::bench
