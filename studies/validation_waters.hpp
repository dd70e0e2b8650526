// Cases with walls.
#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <vector>

#include "sluice/scene.hpp"
#include "studies/time_curve.hpp"
#include "studies/validation.hpp"

namespace sluice::study {

ValidationCase tank_case();
ValidationCase dam_case();
ValidationCase wave_case();

/// How far the faces of mirror walls with three layers are from the corner of the container, in spacings.
constexpr double wall_faces = 2.5;

/// Mean pressure of the water in a tank, in bins as deep as a spacing.
class PressureBins {
 public:
  /// The floor's face lies at `floor`.
  PressureBins(double spacing, double floor) : spacing_(spacing), floor_(floor) {}

  void add(const std::vector<Vec2>& x, const std::vector<double>& pressure);

  /// Height of the surface over the floor, twice that of the centre of mass.
  double level() const;

  /// Root mean square, over the bins, of the mean pressure less `weight` times the depth below the level;
  /// `weight` is rho0 g. Bins at the surface, less than half as full as one under water, are left out.
  double error(double weight) const;

 private:
  struct Bin {
    double count = 0, height = 0, pressure = 0;  ///< sums
  };
  double spacing_, floor_;
  std::vector<Bin> bins_;
};

/// The largest of the sets of particles in which one leads to another by steps of `reach` or less.
std::vector<Vec2> connected_bulk(const std::vector<Vec2>& x, double reach);

/// The x furthest right.
double front_of(const std::vector<Vec2>& bulk);

/// The largest y of those with x < `until`; the least y of all where there is none.
double height_at_wall(const std::vector<Vec2>& bulk, double until);

/// The largest rise of the energy from the least that it has been since it was `start`, relative to `scale`.
double largest_rise(const std::vector<double>& kinetic, const std::vector<double>& potential, double start,
                    double scale);

/// Period of the standing wave of small amplitude, omega² = g k tanh(k depth).
double wave_period(double gravity, double wave_number, double depth);

/// The curve of a CSV file beside the scene of a point.
TimeCurve reference_beside(const std::string& scene, const std::string& file);

}  // namespace sluice::study
