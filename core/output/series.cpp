// Columns of the series.
#include "core/output/series.hpp"

#include "core/text.hpp"

namespace sluice {

SeriesFile::SeriesFile(const std::filesystem::path& path, Precision precision)
    : file_(path), precision_(precision) {
  file_.write(
      "step,time,dt,iterations,residual,mean_density,mean_compression,max_compression,kinetic_energy,"
      "potential_energy,com_x,com_y,max_speed,cfl,wall_force_x,wall_force_y,lost,converged\n");
}

void SeriesFile::add(const StepReport& report) {
  const Diagnostics& d = report.diagnostics;
  std::string row = std::to_string(report.step);
  const auto real = [&](double value) { row += ',' + round_trip(value, precision_); };
  const auto integer = [&](uint64_t value) { row += ',' + std::to_string(value); };
  real(report.time);
  real(report.dt);
  integer(report.iterations);
  for (const double value : {report.residual, d.mean_density, d.mean_compression, d.max_compression,
                             d.kinetic_energy, d.potential_energy, d.centre_of_mass.x, d.centre_of_mass.y,
                             d.max_speed, d.cfl, d.wall_force.x, d.wall_force.y}) {
    real(value);
  }
  integer(d.lost);
  integer(report.converged ? 1 : 0);
  file_.write(row + '\n');
}

}  // namespace sluice
