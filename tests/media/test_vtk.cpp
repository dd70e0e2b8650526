// The files for ParaView, read back from their bytes: every value, where it stands, and the list of times.
#include <gtest/gtest.h>

#include <bit>
#include <cstdlib>

#include "core/output/output_file.hpp"
#include "media/vtk_series.hpp"
#include "sluice/error.hpp"
#include "tests/support/message_of.hpp"
#include "tests/support/vtk_file.hpp"

namespace sluice::test {
namespace {

namespace fs = std::filesystem;

template <class T>
std::vector<T> flat(const std::vector<Vec2>& vectors) {
  std::vector<T> values;
  for (const Vec2 v : vectors) values.insert(values.end(), {static_cast<T>(v.x), static_cast<T>(v.y), T{0}});
  return values;
}

template <class T>
std::vector<T> as(const std::vector<double>& numbers) {
  std::vector<T> values;
  for (const double number : numbers) values.push_back(static_cast<T>(number));
  return values;
}

std::vector<int64_t> from(int64_t first, size_t count) {
  std::vector<int64_t> values;
  for (size_t k = 0; k < count; ++k) values.push_back(first + static_cast<int64_t>(k));
  return values;
}

void check_head(const VtkFile& file, size_t n) {
  EXPECT_TRUE(file.head.starts_with("<?xml version=\"1.0\"?>\n<VTKFile "));
  EXPECT_EQ(attribute(file.head, "<VTKFile", "type"), "PolyData");
  EXPECT_EQ(attribute(file.head, "<VTKFile", "version"), "1.0");
  EXPECT_EQ(attribute(file.head, "<VTKFile", "header_type"), "UInt64");
  EXPECT_EQ(attribute(file.head, "<VTKFile", "byte_order"),
            std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian");
  EXPECT_EQ(attribute(file.head, "<Piece", "NumberOfPoints"), std::to_string(n));
  EXPECT_EQ(attribute(file.head, "<Piece", "NumberOfVerts"), std::to_string(n));
}

template <class T>
void check_points(VtkFile& file, const std::string& type, const std::vector<Vec2>& x) {
  check_head(file, x.size());
  EXPECT_EQ(file.type("Points"), type);
  EXPECT_EQ(file.of_array("Points", "NumberOfComponents"), "3");
  EXPECT_EQ(file.array<T>("Points"), flat<T>(x));
  EXPECT_EQ(file.type("connectivity"), "Int64");
  EXPECT_EQ(file.type("offsets"), "Int64");
  EXPECT_EQ(file.array<int64_t>("connectivity"), from(0, x.size()));
  EXPECT_EQ(file.array<int64_t>("offsets"), from(1, x.size()));
}

template <class T>
void check_fluid(const fs::path& path, const std::string& type, const Snapshot& state) {
  VtkFile file(path);
  check_points<T>(file, type, state.x);
  for (const char* name : {"velocity", "density", "pressure"}) EXPECT_EQ(file.type(name), type) << name;
  EXPECT_EQ(file.of_array("velocity", "NumberOfComponents"), "3");
  EXPECT_EQ(file.of_array("density", "NumberOfComponents"), "1");
  EXPECT_EQ(file.array<T>("velocity"), flat<T>(state.v));
  EXPECT_EQ(file.array<T>("density"), as<T>(state.density));
  EXPECT_EQ(file.array<T>("pressure"), as<T>(state.pressure));
  EXPECT_EQ(file.type("id"), "Int64");
  EXPECT_EQ(file.array<int64_t>("id"), from(0, state.x.size()));
  EXPECT_TRUE(file.gapless()) << file.head;
}

size_t entries(const fs::path& folder) {
  return static_cast<size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(Vtk, KeepsEveryDouble) {
  const TemporaryFolder folder;
  media::VtkSeries series(folder / "new/vtk", {}, Precision::double_);
  // The last is larger than the buffer of a file.
  for (const size_t n : {size_t{1}, size_t{2}, size_t{5000}}) {
    const std::string name = "new/vtk/fluid_00000" + std::to_string(series.count()) + ".vtp";
    series.add(0, some_state(n));
    check_fluid<double>(folder / name, "Float64", some_state(n));
  }
}

TEST(Vtk, SinglePrecisionTakesFourBytes) {
  const TemporaryFolder folder;
  media::VtkSeries series(folder.path, {}, Precision::single_);
  series.add(0, some_state(1000));
  check_fluid<float>(folder / "fluid_000000.vtp", "Float32", some_state(1000));
}

TEST(Vtk, AnEmptyFluidIsAFileToo) {
  const TemporaryFolder folder;
  media::VtkSeries series(folder.path, {}, Precision::single_);
  series.add(0, Snapshot{});
  check_fluid<float>(folder / "fluid_000000.vtp", "Float32", Snapshot{});
}

TEST(Vtk, TheBoundaryIsThereFromTheStart) {
  const TemporaryFolder folder;
  const std::vector<Vec2> boundary = some_state(77, 0.5).x;
  const media::VtkSeries single(folder / "single", boundary, Precision::single_);
  const media::VtkSeries twice(folder / "double", boundary, Precision::double_);
  VtkFile in_single(folder / "single/boundary.vtp"), in_double(folder / "double/boundary.vtp");
  check_points<float>(in_single, "Float32", boundary);
  check_points<double>(in_double, "Float64", boundary);
  EXPECT_TRUE(in_single.gapless());
  EXPECT_TRUE(in_double.gapless());
  EXPECT_EQ(entries(folder / "single"), 1u);
}

TEST(Vtk, EachFileKnowsItsTime) {
  const TemporaryFolder folder;
  media::VtkSeries series(folder.path, {}, Precision::single_);
  series.add(0.1 + 0.2, some_state(3));
  const VtkFile file(folder / "fluid_000000.vtp");
  const std::string tag = "Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">";
  const size_t at = file.head.find(tag);
  ASSERT_NE(at, std::string::npos) << file.head;
  EXPECT_EQ(std::strtod(file.head.c_str() + at + tag.size(), nullptr), 0.1 + 0.2);
  EXPECT_LT(at, file.head.find("<Piece"));
}

TEST(Vtk, TheListNamesEveryTimeAndTheBoundaryWithEach) {
  const TemporaryFolder folder;
  const std::vector<Vec2> boundary{{1, 2}};
  media::VtkSeries series(folder.path, boundary, Precision::single_);
  for (const double time : {0.0, 0.1 + 0.2, 12.5}) series.add(time, some_state(3));
  EXPECT_FALSE(fs::exists(folder / "fluid.pvd"));
  series.finish();
  EXPECT_EQ(series.count(), 3u);
  const std::string order = std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";
  EXPECT_EQ(read_file(folder / "fluid.pvd"),
            "<?xml version=\"1.0\"?>\n"
            "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"" +
                order +
                "\" header_type=\"UInt64\">\n"
                "  <Collection>\n"
                "    <DataSet timestep=\"0\" part=\"0\" name=\"fluid\" file=\"fluid_000000.vtp\"/>\n"
                "    <DataSet timestep=\"0\" part=\"1\" name=\"boundary\" file=\"boundary.vtp\"/>\n"
                "    <DataSet timestep=\"0.30000000000000004\" part=\"0\" name=\"fluid\" "
                "file=\"fluid_000001.vtp\"/>\n"
                "    <DataSet timestep=\"0.30000000000000004\" part=\"1\" name=\"boundary\" "
                "file=\"boundary.vtp\"/>\n"
                "    <DataSet timestep=\"12.5\" part=\"0\" name=\"fluid\" file=\"fluid_000002.vtp\"/>\n"
                "    <DataSet timestep=\"12.5\" part=\"1\" name=\"boundary\" file=\"boundary.vtp\"/>\n"
                "  </Collection>\n"
                "</VTKFile>\n");
  EXPECT_EQ(entries(folder.path), 5u);
}

TEST(Vtk, WithoutABoundaryNothingNamesOne) {
  const TemporaryFolder folder;
  write_file(folder / "boundary.vtp", "of another run");
  media::VtkSeries series(folder.path, {}, Precision::single_);
  series.add(1, some_state(3));
  series.finish();
  const std::string list = read_file(folder / "fluid.pvd");
  EXPECT_NE(list.find("fluid_000000.vtp"), std::string::npos);
  EXPECT_EQ(list.find("boundary"), std::string::npos) << list;
}

TEST(Vtk, FinishesWithoutAFrameAndOnlyOnce) {
  const TemporaryFolder folder;
  media::VtkSeries series(folder.path, {}, Precision::single_);
  series.finish();
  EXPECT_NE(read_file(folder / "fluid.pvd").find("<Collection>\n  </Collection>"), std::string::npos);
  fs::remove(folder / "fluid.pvd");
  series.finish();
  EXPECT_FALSE(fs::exists(folder / "fluid.pvd"));
  EXPECT_THROW(series.add(0, some_state(1)), Error);
  EXPECT_EQ(entries(folder.path), 0u);
}

TEST(Vtk, CountsTheFilesOfALongerRunBefore) {
  const TemporaryFolder folder;
  for (const int k : {0, 1, 2, 3, 4, 6})  // 5 ends the row
    write_file(folder / ("fluid_00000" + std::to_string(k) + ".vtp"), "old");
  media::VtkSeries series(folder.path, {}, Precision::single_);
  EXPECT_EQ(series.older_files(), 5u);
  series.add(0, some_state(2));
  series.add(1, some_state(2));
  series.finish();
  EXPECT_EQ(series.older_files(), 3u);
  EXPECT_EQ(read_file(folder / "fluid_000002.vtp"), "old");
  EXPECT_EQ(read_file(folder / "fluid.pvd").find("fluid_000002"), std::string::npos);
}

TEST(Vtk, ARunThatGoesOnListsWhatIsThereOfTheFirstPart) {
  const TemporaryFolder folder;
  media::VtkSeries first(folder.path, {}, Precision::single_);
  for (const double time : {0.0, 0.1, 0.2, 0.3, 7.0}) first.add(time, some_state(2));
  fs::remove(folder / "fluid_000001.vtp");
  write_file(folder / "fluid_000002.vtp", "of another program");
  // The fourth is of this run, the fifth of one whose frames came later.
  media::VtkSeries second(folder.path, {}, Precision::single_, 6, 0.5);
  second.add(0.6, some_state(2));
  EXPECT_EQ(second.count(), 1u);
  second.finish();
  const std::string list = read_file(folder / "fluid.pvd");
  for (const char* there : {"fluid_000000", "fluid_000003", "fluid_000006"})
    EXPECT_NE(list.find(there), std::string::npos) << there << list;
  for (const char* left_out : {"fluid_000001", "fluid_000002", "fluid_000004", "fluid_000005"})
    EXPECT_EQ(list.find(left_out), std::string::npos) << left_out << list;
  EXPECT_NE(list.find("timestep=\"0.29999999999999999\" part=\"0\" name=\"fluid\" file=\"fluid_000003.vtp\""),
            std::string::npos)
      << list;
}

TEST(Vtk, AFolderThatCannotBeIsReported) {
  const TemporaryFolder folder;
  write_file(folder / "file", "x");
  const fs::path inside = folder / "file" / "vtk";
  const std::string message = message_of([&] { media::VtkSeries(inside, {}, Precision::single_); });
  EXPECT_EQ(message, inside.string() + ": the folder can't be created: Not a directory; choose another");
}

TEST(Vtk, AFailedFileIsReportedAndNotListed) {
  const TemporaryFolder folder;
  const std::vector<Vec2> boundary{{1, 2}};
  fs::create_directories(folder / "a/boundary.vtp");
  fs::create_directories(folder / "b/fluid_000001.vtp");
  const std::string first = message_of([&] { media::VtkSeries(folder / "a", boundary, Precision::single_); });
  EXPECT_NE(first.find("cannot write " + (folder / "a/boundary.vtp").string()), std::string::npos) << first;

  media::VtkSeries series(folder / "b", {}, Precision::single_);
  series.add(0, some_state(2));
  const std::string second = message_of([&] { series.add(1, some_state(2)); });
  EXPECT_NE(second.find("fluid_000001.vtp"), std::string::npos) << second;
  EXPECT_EQ(series.count(), 1u);
  series.finish();
  const std::string list = read_file(folder / "b/fluid.pvd");
  EXPECT_NE(list.find("fluid_000000"), std::string::npos) << list;
  EXPECT_EQ(list.find("fluid_000001"), std::string::npos) << list;
  EXPECT_EQ(entries(folder / "b"), 3u);
}

}  // namespace
}  // namespace sluice::test
