// Names, words and the list of all hard cases.
#include "studies/hard_case.hpp"

#include <fmt/format.h>

namespace sluice::study {

std::string_view name_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::survived: return "survived";
    case Outcome::stopped: return "stopped";
    case Outcome::refused: return "refused";
  }
  return "";
}

std::string text_of(const Expectation& expected) {
  if (expected.outcome != Outcome::survived)
    return fmt::format("{}: {}", name_of(expected.outcome), expected.reason);
  if (expected.may_be_stopped) return fmt::format("survived, or stopped: {}", expected.reason);
  std::string text = fmt::format("survived, lost <= {}", expected.lost);
  const auto add = [&](const char* what, const auto& bound) {
    if (bound) text += fmt::format(", {} {:g}", what, static_cast<double>(*bound));
  };
  add("lost >=", expected.least_lost);
  add("gain <=", expected.energy_gain);
  add("compression <=", expected.mean_compression);
  add("rise <=", expected.rise);
  add("level drift <=", expected.level_drift);
  add("kinetic energy <=", expected.kinetic_end);
  add("closest >=", expected.closest);
  add("list growths <=", expected.list_growths);
  return text;
}

void expect_stop(Expectation& expected, const char* reason) {
  expected.outcome = Outcome::stopped;
  expected.reason = reason;
}

void allow_stop(Expectation& expected, const char* reason) {
  expected.may_be_stopped = true;
  expected.reason = reason;
}

HardCase& HardCases::add(const std::string& topic, const SceneParts& parts) {
  return add(fmt::format("{}_{}", topic, parts.method.suffix), parts.method.label, scene_text(parts));
}

HardCase& HardCases::add(const std::string& name, const std::string& method, const std::string& scene) {
  HardCase fresh;
  fresh.name = name;
  fresh.method = method;
  fresh.scene = scene;
  return cases_.emplace_back(std::move(fresh));
}

std::vector<HardCase> hard_cases() {
  HardCases cases;
  for (const auto add : {add_deep_water, add_time_steps, add_few_particles, add_crowded_starts, add_impacts,
                         add_places, add_numbers}) {
    add(cases);
  }
  return cases.take();
}

}  // namespace sluice::study
