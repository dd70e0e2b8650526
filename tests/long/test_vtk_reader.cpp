// VTK's own reader, which is ParaView's, finds in the files what was in the snapshots.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <map>
#include <sstream>

#include "media/vtk_series.hpp"
#include "tests/support/vtk_file.hpp"

namespace sluice::test {
namespace {

struct Array {
  std::string type;
  size_t components = 0;
  std::vector<double> values;
};

/// A line "file ..." of tests/long/read_vtk.py and the lines under it.
struct ReadFile {
  std::string name, part, label;
  double time = 0;
  size_t points = 0, vertices = 0, cells = 0;
  std::map<std::string, Array> arrays;
};

void read_line(std::vector<ReadFile>& files, const std::string& line) {
  std::istringstream words(line);
  std::string word, name, time;
  words >> word;
  if (word == "file") {
    ReadFile& file = files.emplace_back();
    words >> file.name >> time >> file.part >> file.label;
    file.time = std::strtod(time.c_str(), nullptr);
  } else if (word == "cells") {
    words >> files.back().points >> files.back().vertices >> files.back().cells;
  } else {
    words >> name;
    Array& array = files.back().arrays[name];
    words >> array.type >> array.components;
    while (words >> word) array.values.push_back(std::strtod(word.c_str(), nullptr));
  }
}

/// Debian's package belongs to Debian's Python, which need not be the first in PATH.
std::vector<ReadFile> read_with_vtk(const TemporaryFolder& folder) {
  const std::string out = folder / "out.txt";
  const std::string command =
      std::string("/usr/bin/python3 '" SLUICE_SOURCE_DIR "/tests/long/read_vtk.py' '") +
      (folder / "vtk/fluid.pvd").string() + "' >'" + out + "'";
  const int status = std::system(command.c_str());
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  EXPECT_NE(code, 3) << "this test needs VTK for Python; install the package python3-vtk9";
  EXPECT_NE(code, 127) << "this test needs /usr/bin/python3; install the package python3-vtk9";
  EXPECT_EQ(code, 0);
  std::vector<ReadFile> files;
  std::istringstream lines(read_file(out));
  for (std::string line; std::getline(lines, line);) read_line(files, line);
  return files;
}

/// Through memory: GCC 12 forgets to round when it vectorises a choice between a value and its rounded self.
double rounded(double value, Precision precision) {
  const volatile float single = static_cast<float>(value);
  return precision == Precision::single_ ? static_cast<double>(single) : value;
}

std::vector<double> flat(const std::vector<Vec2>& vectors, Precision precision) {
  std::vector<double> values;
  for (const Vec2 v : vectors)
    values.insert(values.end(), {rounded(v.x, precision), rounded(v.y, precision), 0.0});
  return values;
}

void expect(const Array& array, const std::string& type, size_t components, std::vector<double> values) {
  EXPECT_EQ(array.type, type);
  EXPECT_EQ(array.components, components);
  EXPECT_EQ(array.values, values);
}

void expect_points(ReadFile& file, const std::vector<Vec2>& x, Precision precision, const std::string& type) {
  EXPECT_EQ(file.points, x.size());
  EXPECT_EQ(file.vertices, x.size());
  EXPECT_EQ(file.cells, x.size());
  std::vector<double> ids;
  for (size_t i = 0; i < x.size(); ++i) ids.push_back(static_cast<double>(i));
  expect(file.arrays["vertices"], "cells", 1, ids);
  if (!x.empty()) expect(file.arrays["Points"], type, 3, flat(x, precision));
}

void expect_fluid(ReadFile& file, const Snapshot& state, double time, Precision precision) {
  const std::string type = precision == Precision::single_ ? "float" : "double";
  expect_points(file, state.x, precision, type);
  std::vector<double> density, pressure;
  for (const double value : state.density) density.push_back(rounded(value, precision));
  for (const double value : state.pressure) pressure.push_back(rounded(value, precision));
  expect(file.arrays["velocity"], type, 3, flat(state.v, precision));
  expect(file.arrays["density"], type, 1, density);
  expect(file.arrays["pressure"], type, 1, pressure);
  EXPECT_EQ(file.arrays["id"].values, file.arrays["vertices"].values);
  EXPECT_EQ(file.arrays["id"].components, 1u);
  expect(file.arrays["TimeValue"], "double", 1, {time});
  EXPECT_EQ(file.time, time);
}

class VtkReader : public testing::TestWithParam<Precision> {};

TEST_P(VtkReader, FindsWhatWasWritten) {
  const TemporaryFolder folder;
  const std::vector<Vec2> boundary = some_state(41, 0.25).x;
  const std::vector<double> times{0, 0.1 + 0.2, 1e-7};
  const std::vector<Snapshot> states{some_state(3000, 0), some_state(3000, 0.5), Snapshot{}};
  media::VtkSeries series(folder / "vtk", boundary, GetParam());
  for (size_t k = 0; k < times.size(); ++k) series.add(times[k], states[k]);
  series.finish();

  std::vector<ReadFile> files = read_with_vtk(folder);
  ASSERT_EQ(files.size(), 2 * times.size());
  for (size_t k = 0; k < times.size(); ++k) {
    SCOPED_TRACE(files[2 * k].name);
    EXPECT_EQ(files[2 * k].label + files[2 * k].part, "fluid0");
    expect_fluid(files[2 * k], states[k], times[k], GetParam());
    ReadFile& around = files[2 * k + 1];
    EXPECT_EQ(around.label + around.part, "boundary1");
    EXPECT_EQ(around.time, times[k]);
    expect_points(around, boundary, GetParam(), GetParam() == Precision::single_ ? "float" : "double");
    EXPECT_EQ(around.arrays.size(), 2u);
  }
}

INSTANTIATE_TEST_SUITE_P(Both, VtkReader, testing::Values(Precision::single_, Precision::double_));

}  // namespace
}  // namespace sluice::test
