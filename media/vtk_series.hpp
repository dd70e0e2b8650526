// A run for ParaView: one VTK XML PolyData file per frame, and a .pvd that lists them with their times.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <utility>
#include <vector>

#include "core/solver/backend.hpp"
#include "sluice/report.hpp"

namespace sluice::media {

/// A folder with fluid_000000.vtp, fluid_000001.vtp, ..., boundary.vtp and fluid.pvd, which names them all.
/// Points lie in the plane z = 0; the units are the scene's own. A failed write is an EnvironmentError.
class VtkSeries {
 public:
  /// Creates the folder and writes boundary.vtp, if there is a boundary. Numbers take four bytes in single
  /// precision, eight in double. A run that goes on begins with file `first`; of those before it fluid.pvd
  /// lists what is there, up to the time `until`.
  VtkSeries(std::filesystem::path folder, std::span<const Vec2> boundary, Precision precision,
            uint64_t first = 0, double until = 0);

  /// Writes the next file: position, velocity, density, pressure and id of every particle.
  void add(double time, const Snapshot& state);

  /// Writes fluid.pvd, which lists what was added so far; a second call does nothing. Nothing may be added
  /// afterwards.
  void finish();

  uint64_t count() const { return times_.size(); }  ///< files of fluid so far
  /// Number of files of an earlier, longer run that follow this run's own in the folder; fluid.pvd does not
  /// list them.
  uint64_t older_files() const;

 private:
  std::filesystem::path folder_;
  Precision precision_;
  bool has_boundary_;
  bool finished_ = false;
  std::vector<std::pair<uint64_t, double>> earlier_;  // number and time
  uint64_t first_;
  std::vector<double> times_;
};

}  // namespace sluice::media
