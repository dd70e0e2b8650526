// Drops without walls: one that swings and one that is drawn out.
#include "studies/validation_drops.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/settings.hpp"

namespace sluice::study {
namespace {

using Words = Settings;

/// The time of that change of sign after the start, which is round but for rounding; NaN where there are
/// fewer.
double time_of_change(size_t number, const std::vector<double>& times, const std::vector<double>& values) {
  if (values.size() < 4) return unknown_number;
  for (size_t i = 1, changes = 0; i + 1 < values.size(); ++i)
    if ((values[i] < 0) != (values[i + 1] < 0) && ++changes == number) return zero_after(i, times, values);
  return unknown_number;
}

Words smoothed(Words words) { return with(std::move(words), {"particles.smoothing=1.2"}); }
Words from_a_lattice(Words words) { return with(std::move(words), {"fluid.jitter=0", "fluid.relax=0"}); }

// At most 0.3 spacings a step with IISPH; with the others 0.4 spacings of sound.
Words swinging_iisph(int n) { return with_method("iisph", 0.4 / n); }
Words swinging(const char* method, int n) { return with_method(method, 0.056 / n); }
Words drawn_iisph(int n) { return with_method("iisph", 2e-3 / n); }
Words drawn(const char* method, int n) { return with_method(method, 4e-4 / n); }

}  // namespace

std::vector<std::string> with_method(const char* method, double dt) {
  return {fmt::format("pressure.method={}", method), fmt::format("time.dt={:.17g}", dt)};
}

std::vector<Measure> oscillation_measures(const IdealDrop& drop, const std::vector<Blob>& blobs) {
  const double period = drop.period();
  std::vector<double> times, a, b, lead, energy;  // a and b: errors
  double largest = 0;
  for (const Blob& blob : blobs) {
    const IdealDrop::State exact = drop.at(blob.time);
    times.push_back(blob.time);
    a.push_back(blob.semi_axes.x - exact.a);
    b.push_back(blob.semi_axes.y - exact.b);
    lead.push_back(blob.semi_axes.x - blob.semi_axes.y);
    energy.push_back(blob.kinetic + drop.omega_squared * blob.distance_squared / 2);
    if (blob.time <= period) largest = std::max({largest, std::abs(a.back()), std::abs(b.back())});
  }
  const double after = std::max(std::abs(value_at(period, times, a)), std::abs(value_at(period, times, b)));
  const double found = time_of_change(2, times, lead);
  const double lost = (energy.front() - value_at(period, times, energy)) / blobs.front().kinetic;
  return {{"semi-axes after a period", unknown_number, unknown_number, after / drop.radius},
          {"semi-axes, largest error", unknown_number, unknown_number, largest / drop.radius},
          {"period", found, period, std::abs(found / period - 1)},
          {"energy per period", lost, 0, std::abs(lost)}};
}

std::vector<Measure> elongation_measures(const IdealDrop& drop, const std::vector<Blob>& blobs) {
  Measure major{"major semi-axis"}, minor{"minor semi-axis"};
  const auto take = [](Measure& measure, double ours, double reference) {
    const double error = std::abs(ours / reference - 1);
    if (error >= measure.error) measure = {measure.quantity, ours, reference, error};
  };
  for (const Blob& blob : blobs) {
    const IdealDrop::State exact = drop.at(blob.time);
    take(drop.rate > 0 ? major : minor, blob.semi_axes.x, exact.a);
    take(drop.rate > 0 ? minor : major, blob.semi_axes.y, exact.b);
  }
  return {major, minor};
}

std::vector<ValidationCase> drop_cases() {
  ValidationCase oscillating;
  oscillating.name = "oscillating_drop";
  oscillating.limits = {{"semi-axes after a period", 0.006, 0.0015},
                        {"period", 0.003, 0.0005},
                        {"energy per period", 0.06, 0.02}};
  oscillating.variants = {
      {"iisph", "IISPH", swinging_iisph},
      {"iisph_smoothed", "IISPH, smoothing 1.2", [](int n) { return smoothed(swinging_iisph(n)); }},
      {"iisph_lattice", "IISPH, from a lattice", [](int n) { return from_a_lattice(swinging_iisph(n)); }},
      {"ssph", "SSPH", [](int n) { return swinging("ssph", n); }},
      {"wcsph", "WCSPH", [](int n) { return swinging("wcsph", n); }}};
  oscillating.words = {"--fps", "8"};
  oscillating.recording = true;
  oscillating.measure = [](const Result& result) {
    return oscillation_measures(oscillating_drop, blobs_of(result.files.recording));
  };

  ValidationCase elliptic;
  elliptic.name = "elliptic_drop";
  elliptic.limits = {{"major semi-axis", 0.005, 0}, {"minor semi-axis", 0.025, 0.007}};
  elliptic.variants = {
      {"iisph", "IISPH", drawn_iisph},
      {"iisph_smoothed", "IISPH, smoothing 1.2", [](int n) { return smoothed(drawn_iisph(n)); }},
      {"iisph_lattice", "IISPH, from a lattice", [](int n) { return from_a_lattice(drawn_iisph(n)); }},
      {"ssph", "SSPH", [](int n) { return drawn("ssph", n); }},
      {"wcsph", "WCSPH", [](int n) { return drawn("wcsph", n); }}};
  elliptic.words = {"--fps", "2500"};
  elliptic.recording = true;
  elliptic.measure = [](const Result& result) {
    return elongation_measures(elliptic_drop, blobs_of(result.files.recording));
  };

  std::vector<ValidationCase> cases = {std::move(oscillating), std::move(elliptic)};
  std::ranges::move(motion_cases(), std::back_inserter(cases));
  return cases;
}

}  // namespace sluice::study
