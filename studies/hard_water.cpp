// Water at rest: columns as deep as hundreds of particles, films, a tank for a minute.
#include <cmath>

#include "studies/hard_case.hpp"

namespace sluice::study {
namespace {

/// lambda h / sqrt(g depth)
double depth_step(double lambda, uint32_t rows) { return lambda * h / std::sqrt(g * rows * h); }

/// A state equation that gives way by 1 % under this depth, and nine tenths of the time that sound takes over
/// a spacing.
double stiffness(uint32_t rows) { return 100 * g * rows * h; }
double sound_step(uint32_t rows) { return 0.9 * h / std::sqrt(stiffness(rows)); }

HardCase& add_column(HardCases& cases, uint32_t columns, uint32_t rows, const Method& method, double dt,
                     double duration) {
  SceneParts tank =
      full_tank(fmt::format("Column {} wide and {} deep", columns, rows), columns, rows, method);
  tank.time = fixed(dt, duration);
  return cases.add(fmt::format("column_{}x{}", columns, rows), tank);
}

/// How long a column is watched: the deeper, the more a second costs.
double duration(uint32_t rows) { return rows <= 100 ? 20 : rows <= 200 ? 10 : 5; }

void add_columns(HardCases& cases) {
  for (const uint32_t rows : {30u, 100u, 200u, 500u}) {
    const double dt = depth_step(0.4, rows);
    HardCase& recommended = add_column(cases, 10, rows, iisph(), dt, duration(rows));
    recommended.quick = rows == 30;
    recommended.expected.mean_compression = 0.005;
    recommended.expected.lost = rows == 500 ? 1 : 0;
    HardCase& tight = add_column(cases, 10, rows, at_tolerance(iisph(), 1e-4), dt, duration(rows));
    tight.expected.mean_compression = 0.005;
    tight.expected.lost = rows == 500 ? 1 : 0;
    add_column(cases, 10, rows, iisph_of_the_thesis(), dt, duration(rows));
    if (rows <= 100) add_column(cases, 10, rows, at_tolerance(iisph_of_the_thesis(), 1e-4), dt, 5);
    if (rows <= 100) add_column(cases, 10, rows, ssph(stiffness(rows)), sound_step(rows), 20);
  }
}

void add_extremes(HardCases& cases) {
  for (const Method& method : {iisph(), iisph_of_the_thesis()}) {
    HardCase& shaft = add_column(cases, 1, 200, method, depth_step(0.4, 200), 20);

    // That wall pushes with more than it feels, and here every particle leans on two of them.
    if (method.suffix == "thesis") allow_stop(shaft.expected, blown_up);
    SceneParts film = full_tank("Film 5 deep and 1000 wide", 1000, 5, method);
    film.time = fixed(0.05, 5);
    cases.add("film_1000x5", film).expected.rise = 1;
  }
}

void add_tanks(HardCases& cases) {
  struct Tank {
    Method method;
    double dt;
  };
  for (const auto& [method, dt] :
       {Tank{iisph(), 0.05}, Tank{iisph_of_the_thesis(), 0.05}, Tank{ssph(stiffness(20)), sound_step(20)}}) {
    SceneParts tank = full_tank("A tank at rest for a minute", 80, 20, method);
    tank.time = fixed(dt, 60);
    HardCase& hard = cases.add("tank_at_rest", tank);
    hard.expected.level_drift = 1;
    hard.expected.kinetic_end = 3e-3;
    hard.expected.rise = 1;
  }
}

}  // namespace

void add_deep_water(HardCases& cases) {
  add_columns(cases);
  add_extremes(cases);
  add_tanks(cases);
}

}  // namespace sluice::study
