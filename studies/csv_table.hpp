// CSV tables with a header, read back: series, states, references.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sluice::study {

/// The cells as they are written. Lines that begin with # are left out.
struct CsvTable {
  std::filesystem::path file;
  std::string header;
  std::vector<std::string> names;
  std::vector<std::vector<std::string>> rows;

  size_t size() const { return rows.size(); }
  /// InputError where there is no such column, or no number.
  const std::string& text(size_t row, const std::string& name) const;
  double at(size_t row, const std::string& name) const;
  std::vector<double> column(const std::string& name) const;

 private:
  size_t place(const std::string& name) const;
};

/// InputError when the file can't be read, when a row has more or fewer cells than the header, or when the
/// last line is not ended. Cells may be quoted, but hold no line ends.
CsvTable read_csv(const std::filesystem::path& path);

}  // namespace sluice::study
