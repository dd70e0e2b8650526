// Motions that every method keeps but for rounding: in a straight line, in free fall, and turning.
#include <algorithm>
#include <cmath>

#include "studies/validation_drops.hpp"

namespace sluice::study {
namespace {

/// Of double precision. Float is what the table says.
constexpr double rounding = 1e-12;

ValidationCase flight(const char* name, const char* fps, const std::vector<const char*>& exact) {
  ValidationCase known;
  known.name = name;
  for (const char* quantity : exact) known.limits.push_back({quantity, rounding, rounding});
  known.words = {"--fps", fps};
  known.recording = true;
  return known;
}

double dt_of(const Result& result) { return result.number("settings/time/dt"); }

}  // namespace

std::vector<Measure> motion_measures(const FreeMotion& motion, const std::vector<Blob>& blobs) {
  const auto velocity = [&](double t) { return motion.velocity + t * motion.gravity; };
  const auto travelled = [&](double t) {
    return t * motion.velocity + t * (t + motion.dt) / 2 * motion.gravity;
  };
  const Blob &start = blobs.front(), &end = blobs.back();
  double place = 0, speed = 0;
  for (const Blob& blob : blobs) {
    place = std::max(place, glm::length(blob.centre - start.centre - travelled(blob.time)));
    speed = std::max(speed, glm::length(blob.velocity - velocity(blob.time)));
  }
  std::vector<Measure> measures = {
      {"centre of mass", unknown_number, unknown_number, place / glm::length(travelled(end.time))},
      {"momentum", unknown_number, unknown_number, speed / glm::length(velocity(end.time))}};
  if (motion.gravity.y != 0) {
    const double ours = end.centre.y - start.centre.y - end.time * motion.velocity.y;
    const double reference = motion.gravity.y * end.time * end.time / 2;
    measures.push_back({"fall", ours, reference, std::abs(ours / reference - 1)});
  }
  return measures;
}

std::vector<Measure> rotation_measures(const std::vector<Blob>& blobs) {
  const double start = blobs.front().angular_momentum;
  Measure measure{"angular momentum", start, start, 0};
  for (const Blob& blob : blobs) {
    const double error = std::abs(blob.angular_momentum / start - 1);
    if (error >= measure.error) measure = {measure.quantity, blob.angular_momentum, start, error};
  }
  return {measure};
}

std::vector<ValidationCase> motion_cases() {
  ValidationCase uniform = flight("uniform_motion", "10", {"centre of mass", "momentum"});
  uniform.variants = {{"iisph", "IISPH", [](int n) { return with_method("iisph", 0.2 / n); }},
                      {"ssph", "SSPH", [](int n) { return with_method("ssph", 0.04 / n); }},
                      {"wcsph", "WCSPH", [](int n) { return with_method("wcsph", 0.04 / n); }}};
  uniform.measure = [](const Result& result) {
    return motion_measures({.velocity = {1, 0.5}, .dt = dt_of(result)}, blobs_of(result.files.recording));
  };

  ValidationCase fall = flight("free_fall", "20", {"centre of mass", "momentum"});
  fall.variants = {{"iisph", "IISPH", [](int n) { return with_method("iisph", 0.04 / n); }},
                   {"ssph", "SSPH", [](int n) { return with_method("ssph", 0.04 / n); }},
                   {"wcsph", "WCSPH", [](int n) { return with_method("wcsph", 0.04 / n); }}};
  fall.measure = [](const Result& result) {
    return motion_measures({.gravity = {0, -9.81}, .dt = dt_of(result)}, blobs_of(result.files.recording));
  };

  ValidationCase rotating = flight("rotating_blob", "10", {"angular momentum"});
  rotating.variants = {{"iisph", "IISPH", [](int n) { return with_method("iisph", 0.2 / n); }},
                       {"ssph", "SSPH", [](int n) { return with_method("ssph", 0.056 / n); }},
                       {"wcsph", "WCSPH", [](int n) { return with_method("wcsph", 0.056 / n); }}};
  rotating.measure = [](const Result& result) { return rotation_measures(blobs_of(result.files.recording)); };
  for (ValidationCase* exact : {&uniform, &fall, &rotating}) exact->exact = true;
  return {uniform, fall, rotating};
}

}  // namespace sluice::study
