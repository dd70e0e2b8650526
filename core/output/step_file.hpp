// A CSV file to which every step adds rows.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "core/output/output_file.hpp"
#include "sluice/report.hpp"

namespace sluice {

class StepFile {
 public:
  /// Opens the file and writes its header; `rows` gives what a step adds, lines with their ends.
  StepFile(const std::filesystem::path& path, const std::string& header,
           std::function<std::string(const StepReport&)> rows)
      : file_(path), rows_(std::move(rows)) {
    file_.write(header + '\n');
  }

  void add(const StepReport& report) { file_.write(rows_(report)); }
  void commit() { file_.commit(); }

 private:
  OutputFile file_;
  std::function<std::string(const StepReport&)> rows_;
};

/// The convergence of every pressure solve: a row per sweep. The steps have to report them.
StepFile sweeps_file(const std::filesystem::path& path);

}  // namespace sluice
