// Whether a fluid without viscosity stays together.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "media/recording.hpp"
#include "studies/timestep_verdicts.hpp"

namespace sluice::study {
namespace {

struct End {
  double energy = 0;
  double lost = 0, time = 0;
};

}  // namespace

bool is_trial(const Result& result) { return result.point.fact("start") != "-1"; }

double kinetic_energy_at_end(const std::filesystem::path& file) {
  const media::Recording recording(file);
  const Scene& scene = recording.scene();
  const size_t frames = std::min<size_t>(10, recording.frames());
  double sum = 0;
  for (size_t frame = recording.frames() - frames; frame < recording.frames(); ++frame) {
    const media::Moment moment = recording.moment(frame);
    for (size_t i = 0; i < moment.state.x.size(); ++i) {
      const Vec2 x = moment.state.x[i], v = moment.state.v[i];
      const bool inside = x.x >= scene.domain_min.x && x.x <= scene.domain_max.x && x.y >= scene.domain_min.y;
      if (inside) sum += 0.5 * scene.mass() * (v.x * v.x + v.y * v.y);
    }
  }
  return sum / static_cast<double>(frames);
}

void judge_coherence(const std::vector<Result>& results, Verdicts& verdicts) {
  std::map<std::pair<std::string, std::string>, std::map<std::string, End>> ends;
  for (const Result& result : results) {
    if (is_trial(result)) continue;
    ends[{result.point.fact("method"), result.point.fact("dt")}][result.point.fact("nu")] = {
        kinetic_energy_at_end(result.files.recording), result.number("lost"), result.number("time")};
  }
  for (const auto& [run, by_nu] : ends) {
    if (by_nu.size() < 2) continue;
    const End &inviscid = by_nu.at("0"), &viscous = by_nu.at("200");
    const double times = inviscid.energy / viscous.energy;
    const bool incoherent = run.first == "SSPH";
    verdicts.add(
        fmt::format("section 6.2: {} at nu = 0, dt = {}, {}", run.first, run.second,
                    incoherent ? "does not stay together" : "stays together"),
        incoherent ? "spreads over the tank" : "does not spread",
        fmt::format("kinetic energy in the tank at the end {:.1f} times that at nu = 200; {:g} lost by "
                    "t = {:.0f}",
                    times, inviscid.lost, inviscid.time),
        incoherent == (times > 10));
  }
}

}  // namespace sluice::study
