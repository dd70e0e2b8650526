// The series of a run: one CSV row per step.
#pragma once

#include <filesystem>

#include "core/output/output_file.hpp"
#include "core/solver/simulator.hpp"

namespace sluice {

class SeriesFile {
 public:
  /// Opens the file and writes its header.
  SeriesFile(const std::filesystem::path& path, Precision precision);
  void add(const StepReport& report);
  void commit() { file_.commit(); }

 private:
  OutputFile file_;
  Precision precision_;
};

}  // namespace sluice
