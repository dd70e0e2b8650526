// The limits of a valid run, and the search for the particle that broke one.
#include "core/solver/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sluice {
namespace {

constexpr double largest_cfl = 100;
constexpr double largest_lost_share = 0.1;

bool is_finite(Vec2 a) { return std::isfinite(a.x) && std::isfinite(a.y); }

bool is_finite(const Snapshot& snapshot, size_t i) {
  return is_finite(snapshot.x[i]) && is_finite(snapshot.v[i]) && std::isfinite(snapshot.density[i]) &&
         std::isfinite(snapshot.pressure[i]);
}

bool too_fast(const StepReport& report) { return report.diagnostics.cfl > largest_cfl; }

bool too_many_lost(const StepReport& report, const Params& params) {
  return report.diagnostics.lost > largest_lost_share * params.n;
}

uint32_t first_with(size_t n, auto condition) {
  for (uint32_t i = 0; i < n; ++i) {
    if (condition(i)) return i;
  }
  return 0;
}

uint32_t fastest(const std::vector<Vec2>& v) {
  uint32_t id = 0;
  // hypot, since the square of a speed may be infinite where the speed is not
  const auto speed = [&](uint32_t i) { return std::hypot(v[i].x, v[i].y); };
  for (uint32_t i = 1; i < v.size(); ++i) {
    if (speed(i) > speed(id)) id = i;
  }
  return id;
}

}  // namespace

bool is_suspect(const StepReport& report, const Params& params) {
  return !report.diagnostics.finite() || too_fast(report) || too_many_lost(report, params);
}

bool is_finite(const Snapshot& snapshot) {
  for (size_t i = 0; i < snapshot.x.size(); ++i) {
    if (!is_finite(snapshot, i)) return false;
  }
  return true;
}

Failure find_failure(const StepReport& report, const Params& params, const Snapshot& before,
                     const Snapshot& after) {
  Failure failure{report.step, report.time, 0, {}, {}};
  const size_t n = after.x.size();
  if (!is_finite(after)) {
    failure.id = first_with(n, [&](uint32_t i) { return !is_finite(after, i); });
    failure.reason = "a value is not finite";
  } else if (too_fast(report)) {
    failure.id = fastest(after.v);
    const Vec2 v = after.v[failure.id];  // its square, of which the totals know, may be infinite
    failure.reason = fmt::format("a particle moved by {:.3g} spacings in one step, more than {:g}",
                                 std::hypot(v.x, v.y) * params.dt / params.h, largest_cfl);
  } else if (too_many_lost(report, params)) {
    failure.id = first_with(n, [&](uint32_t i) { return is_lost(params, after.x[i] - params.origin); });
    failure.reason = fmt::format("{} of {} particles are lost, more than {:g} %", report.diagnostics.lost,
                                 params.n, 100 * largest_lost_share);
  } else {
    failure.id = fastest(after.v);
    failure.reason = "a total over all particles is not finite";
  }
  failure.x = is_finite(after.x[failure.id]) ? after.x[failure.id] : before.x[failure.id];
  return failure;
}

Failure find_runaway(const StepReport& report, const Params& params, double cfl, const Snapshot& after) {
  const uint32_t id = fastest(after.v);
  return {report.step,
          report.time,
          id,
          after.x[id],
          fmt::format("the time step collapsed: even with dt {:g} a particle moved by {:.3g} spacings, more "
                      "than time.cfl {:g}",
                      params.dt, report.diagnostics.cfl, cfl),
          true};
}

Failure find_crowd(const StepReport& report, const Params& params, const Snapshot& before) {
  std::vector<uint32_t> members(size_t{params.columns} * params.rows);
  for (const Vec2 x : before.x) ++members[cell_of(params, x - params.origin)];
  const auto fullest = std::max_element(members.begin(), members.end());
  const auto cell = static_cast<uint32_t>(fullest - members.begin());
  const uint32_t id = first_with(
      before.x.size(), [&](uint32_t i) { return cell_of(params, before.x[i] - params.origin) == cell; });
  return {report.step, report.time, id, before.x[id],
          fmt::format("{} particles crowd together in a cell of the grid, where about {:.0f} have room",
                      *fullest, 1 / (params.inverse_cell * params.inverse_cell * params.h * params.h))};
}

}  // namespace sluice
