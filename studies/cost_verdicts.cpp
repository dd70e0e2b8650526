// What [Hunkler 2022, section 6.4] concludes from its tables, asked of ours.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "studies/cost.hpp"
#include "studies/verdicts.hpp"

namespace sluice::study {
namespace {

using Costs = std::vector<Cost>;

constexpr const char* barzilai_borwein = "IISPH, Barzilai-Borwein";

Costs of(const Costs& costs, const std::string& scene, const std::string& method) {
  Costs some;
  std::ranges::copy_if(costs, std::back_inserter(some),
                       [&](const Cost& cost) { return cost.scene == scene && cost.method == method; });
  return some;
}

const Cost* at(const Costs& costs, const std::string& dt) {
  const auto found = std::ranges::find(costs, dt, &Cost::dt);
  return found == costs.end() ? nullptr : &*found;
}

/// Of those that stayed valid, if any did.
const Cost& fastest(const Costs& costs) {
  return *std::ranges::min_element(
      costs, {}, [](const Cost& cost) { return std::pair(!cost.valid, cost.step_seconds); });
}

double share(const Cost& cost) { return cost.pressure_seconds / cost.step_seconds; }

/// Largest over smallest time of a run with one of these steps.
double range(const Costs& costs, const std::vector<std::string>& steps) {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const std::string& dt : steps) {
    const Cost* cost = at(costs, dt);
    if (cost == nullptr) return unknown_number;
    least = std::min(least, cost->step_seconds);
    most = std::max(most, cost->step_seconds);
  }
  return most / least;
}

/// What a step takes without its pressure, in sweeps.
double rest_in_sweeps(const Cost& cost) {
  return (cost.step_seconds - cost.pressure_seconds) / cost.pressure_seconds * cost.iterations;
}

std::string growth(const Costs& costs, const std::function<double(const Cost&)>& value, const char* format) {
  return fmt::format("{} at dt = {} to {} at {}", fmt::format(fmt::runtime(format), value(costs.front())),
                     costs.front().dt, fmt::format(fmt::runtime(format), value(costs.back())),
                     costs.back().dt);
}

void judge_growth(const Costs& jacobi, const std::string& scene, const std::string& theirs,
                  const std::string& their_share, Verdicts& verdicts) {
  verdicts.add(fmt::format("{}: more sweeps per step with larger dt", scene), theirs,
               growth(jacobi, &Cost::iterations, "{:.2f}"),
               std::ranges::is_sorted(jacobi, {}, &Cost::iterations));
  verdicts.add(fmt::format("{}: and a larger share of the time for pressure", scene), their_share,
               growth(
                   jacobi, [](const Cost& cost) { return 100 * share(cost); }, "{:.0f} %"),
               std::ranges::is_sorted(jacobi, {}, share));
}

/// The thesis has Jacobi only.
std::string why_of_solver(const std::string& method) {
  return method == barzilai_borwein ? "its sweeps grow less with dt, so longer steps go on to pay" : "";
}

struct Best {
  std::string dt;
  std::vector<std::string> flat;
  double range = 0;
};

void judge_best(const Costs& costs, const std::string& method, const std::string& scene, const Best& theirs,
                Verdicts& verdicts) {
  const Cost& best = fastest(costs);
  const Cost* same = at(costs, theirs.dt);
  if (same == nullptr) return;
  const double slower = same->step_seconds / best.step_seconds;
  const std::string why =
      fmt::format("a step without its pressure takes as long as {:.1f} sweeps", rest_in_sweeps(*same));
  verdicts.add(fmt::format("{}: {} is fastest at dt = {}", scene, method, theirs.dt), theirs.dt,
               best.dt == theirs.dt
                   ? best.dt
                   : fmt::format("{}; {} takes {:.2f} times as long", best.dt, theirs.dt, slower),
               best.dt == theirs.dt, why);
  const double flat = range(costs, theirs.flat);
  if (std::isnan(flat)) return;
  verdicts.add(fmt::format("{}: {} takes about as long for dt = {} to {}", scene, method, theirs.flat.front(),
                           theirs.flat.back()),
               fmt::format("within a factor of {:.2f}", theirs.range), fmt::format("{:.2f}", flat),
               flat <= 1.15, why_of_solver(method));
}

/// `theirs` is the time of SSPH over that of the fastest IISPH.
void judge_race(const Costs& ssph, const Costs& iisph, const std::string& method, const std::string& scene,
                const std::string& dt, double theirs, Verdicts& verdicts) {
  const Cost* state = at(ssph, dt);
  if (state == nullptr || iisph.empty()) return;
  const double ours = state->step_seconds / fastest(iisph).step_seconds;
  const auto text = [](double ratio) {
    return ratio > 1 ? fmt::format("IISPH by {:.2f}", ratio) : fmt::format("SSPH by {:.2f}", 1 / ratio);
  };
  verdicts.add(fmt::format("{}: {} {} SSPH", scene, method, theirs > 1 ? "beats" : "is beaten by"),
               text(theirs), fmt::format("{}, dt = {} against {}", text(ours), fastest(iisph).dt, dt),
               (ours > 1) == (theirs > 1), why_of_solver(method));
}

std::string why_of_starts(const std::vector<Starts>& starts, const std::string& dt) {
  const auto those = std::ranges::find(starts, dt, &Starts::dt);
  if (those == starts.end()) return "";
  return fmt::format("of {} jittered starts {} lose particles", those->starts, those->with_losses);
}

void judge_ssph(const Costs& ssph, const std::string& scene, const std::string& dt, double their_share,
                const std::vector<Starts>& starts, Verdicts& verdicts) {
  const Cost* state = at(ssph, dt);
  if (state == nullptr) return;
  verdicts.add(fmt::format("{}: SSPH's stiffness keeps the mean compression under 0.1 %", scene),
               "under \"0.01 %\", which is its 0.001", fmt::format("{:.2e}", state->compression),
               state->compression < 1e-3);
  verdicts.add(fmt::format("{}: SSPH's pressure takes next to no time", scene),
               fmt::format("{:.2f} %", 100 * their_share), fmt::format("{:.2f} %", 100 * share(*state)),
               share(*state) < 0.02);
  verdicts.add(fmt::format("{}: SSPH is stable at dt = {}", scene, dt), "stable",
               fmt::format("largest cfl {:.2f}, {:g} lost", state->cfl_max, state->lost),
               state->valid && state->lost == 0 && state->cfl_max < 0.5, why_of_starts(starts, dt));
}

/// Whether single particles stray is chance: it is asked of all starts.
void judge_strays(const std::vector<Starts>& all, const std::string& dt, const std::string& theirs,
                  Verdicts& verdicts) {
  const auto those = std::ranges::find(all, dt, &Starts::dt);
  if (those == all.end()) return;
  verdicts.add(fmt::format("dam: SSPH at dt = {}", dt), theirs,
               fmt::format("{} of {} starts lose particles, largest cfl {:.2f}", those->with_losses,
                           those->starts, those->cfl_max),
               2 * those->with_losses > those->starts || those->cfl_max > 0.5,
               "single particles depend on every bit of the start; the table above has more time steps");
}

void judge_next_step(const Costs& ssph, const std::string& dt, Verdicts& verdicts) {
  const Cost* state = at(ssph, dt);
  if (state == nullptr) return;
  verdicts.add(
      fmt::format("leak: SSPH at dt = {}", dt), "0.004 is the largest stable one",
      state->valid ? fmt::format("largest cfl {:.2f}, {:g} lost", state->cfl_max, state->lost) : "blows up",
      !state->valid || state->cfl_max > 0.5);
}

void judge_tuning(const Costs& costs, Verdicts& verdicts) {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const Cost& cost : costs) {
    if (!cost.method.starts_with("IISPH")) continue;
    least = std::min(least, cost.compression);
    most = std::max(most, cost.compression);
  }
  if (most == 0) return;  // no IISPH
  verdicts.add(
      "SSPH's stiffness has to be found first, IISPH keeps its density error by itself", "so",
      fmt::format("mean compression {:.1e} to {:.1e} in all runs of IISPH, whatever dt", least, most),
      most < 1.1e-3);
}

}  // namespace

TextTable cost_verdicts(const Costs& costs, const std::vector<Starts>& starts) {
  Verdicts verdicts;
  const std::string jacobi = "IISPH, Jacobi", better = barzilai_borwein;
  if (const Costs dam = of(costs, "breaking_dam", jacobi); dam.size() > 1) {
    const Costs ssph = of(costs, "breaking_dam", "SSPH"), bb = of(costs, "breaking_dam", better);
    judge_growth(dam, "dam", "2.00 at 0.01 to 30.01 at 0.08", "34 % at 0.01 to 84 % at 0.08", verdicts);
    const Best theirs{"0.04", {"0.03", "0.04", "0.05", "0.06"}, 1.07};
    judge_best(dam, jacobi, "dam", theirs, verdicts);
    if (!bb.empty()) judge_best(bb, better, "dam", theirs, verdicts);
    judge_race(ssph, dam, jacobi, "dam", "0.01", 98.09 / 62.38, verdicts);
    judge_race(ssph, bb, better, "dam", "0.01", 98.09 / 62.38, verdicts);
    judge_ssph(ssph, "dam", "0.01", 0.241 / 98.09, starts, verdicts);
    judge_strays(starts, "0.011", "single particles stray", verdicts);
    judge_strays(starts, "0.019", "unstable", verdicts);
  }
  if (const Costs leak = of(costs, "leaking_dam", jacobi); leak.size() > 1) {
    const Costs ssph = of(costs, "leaking_dam", "SSPH"), bb = of(costs, "leaking_dam", better);
    judge_growth(leak, "leak", "2 at 0.004 to 38.82 at 0.02", "33 % at 0.004 to 87 % at 0.02", verdicts);
    const Best theirs{"0.01", {"0.006", "0.008", "0.01", "0.012"}, 1.05};
    judge_best(leak, jacobi, "leak", theirs, verdicts);
    if (!bb.empty()) judge_best(bb, better, "leak", theirs, verdicts);
    judge_race(ssph, leak, jacobi, "leak", "0.004", 649.78 / 738.65, verdicts);
    judge_race(ssph, bb, better, "leak", "0.004", 649.78 / 738.65, verdicts);
    judge_ssph(ssph, "leak", "0.004", 1.49 / 649.78, {}, verdicts);
    judge_next_step(ssph, "0.0045", verdicts);
  }
  judge_tuning(costs, verdicts);
  return verdicts.table();
}

}  // namespace sluice::study
