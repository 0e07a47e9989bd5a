// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <Eigen/Geometry>
#include <algorithm>

#include "app/write/image/color.h"
#include "app/write/result/program_version.h"
#include "app/write/vtk/vtk_files.h"
#include "base/errors.h"
#include "tests/app/write/sample_run.h"

namespace etendue::vtk_files_test {
namespace {

using test::SampleRun;
using test::ScratchFolder;

const std::vector<std::string> primaries = {"red", "green", "blue"};

template <class Reader, class Data>
vtkSmartPointer<Data> read_back(const std::filesystem::path& path) {
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

vtkSmartPointer<vtkUnstructuredGrid> fields_of(const SampleRun& run) {
  const ScratchFolder scratch;
  const std::filesystem::path path = scratch.path() / "fields.vtu";
  write_fields(run.result(), path, path);
  return read_back<vtkXMLUnstructuredGridReader, vtkUnstructuredGrid>(path);
}

vtkSmartPointer<vtkPolyData> walls_of(const SampleRun& run) {
  const ScratchFolder scratch;
  const std::filesystem::path path = scratch.path() / "walls.vtp";
  write_walls(run.result(), path, path);
  return read_back<vtkXMLPolyDataReader, vtkPolyData>(path);
}

std::vector<double> values_of(vtkDataArray& array) {
  std::vector<double> values;
  for (vtkIdType i = 0; i < array.GetNumberOfTuples(); ++i)
    for (int c = 0; c < array.GetNumberOfComponents(); ++c) values.push_back(array.GetComponent(i, c));
  return values;
}

std::vector<Vec3> corners_of(vtkCell& cell) {
  std::vector<Vec3> corners(static_cast<std::size_t>(cell.GetNumberOfPoints()));
  for (std::size_t i = 0; i < corners.size(); ++i)
    cell.GetPoints()->GetPoint(static_cast<vtkIdType>(i), corners[i].data());
  return corners;
}

std::vector<std::string> component_names(vtkDataArray& array) {
  std::vector<std::string> names;
  for (int c = 0; c < array.GetNumberOfComponents(); ++c) names.emplace_back(array.GetComponentName(c));
  return names;
}

std::string unit_of(vtkDataArray& array) {
  const char* unit = array.GetInformation()->Get(vtkDataArray::UNITS_LABEL());
  return unit == nullptr ? "" : unit;
}

std::vector<std::string> names_in(vtkFieldData& fields, const char* array) {
  auto* strings = vtkStringArray::SafeDownCast(fields.GetAbstractArray(array));
  std::vector<std::string> names;
  for (vtkIdType i = 0; strings != nullptr && i < strings->GetNumberOfValues(); ++i)
    names.push_back(strings->GetValue(i));
  return names;
}

TEST(FieldsFile, CanHaveAnyCharacterInTheNamesOfBands) {
  const std::vector<std::string> bands = {"<500 nm", "\"R\" & 'S'", "ü > 1"};
  SampleRun run(bands);
  run.input.units.power = "W'<&\"";
  const auto grid = fields_of(run);
  EXPECT_EQ(component_names(*grid->GetPointData()->GetArray("fluence")), bands);
  EXPECT_EQ(unit_of(*grid->GetPointData()->GetArray("fluence")).substr(0, 5), "W'<&\"");
  EXPECT_EQ(names_in(*grid->GetFieldData(), "band_names"), bands);
  EXPECT_NE(grid->GetPointData()->GetArray("net_flux_<500 nm"), nullptr);
  const std::vector<std::string> units = names_in(*grid->GetFieldData(), "units");
  EXPECT_EQ(std::ranges::count(units, "net_flux_<500 nm: W'<&\"/m^2"), 1);
  EXPECT_EQ(component_names(*walls_of(run)->GetPointData()->GetArray("irradiance")), bands);
}

TEST(FieldsFile, GivesEachCellItsOwnPoints) {
  const SampleRun run({"grey"});
  const auto grid = fields_of(run);
  ASSERT_EQ(grid->GetNumberOfCells(), 6);
  ASSERT_EQ(grid->GetNumberOfPoints(), 24);
  for (int c = 0; c < 6; ++c)
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3& vertex = run.mesh.point(VertexIndex(run.mesh.vertices(CellIndex(c))[i]));
      const double* point = grid->GetPoint(4 * c + static_cast<vtkIdType>(i));
      EXPECT_EQ(Vec3(point[0], point[1], point[2]), vertex);
    }
}

TEST(FieldsFile, HasTetrahedraOfPositiveVolume) {
  const auto grid = fields_of(SampleRun({"grey"}));
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c) {
    const std::vector<Vec3> p = corners_of(*grid->GetCell(c));
    EXPECT_NEAR((p[1] - p[0]).cross(p[2] - p[0]).dot(p[3] - p[0]) / 6, 1.0 / 6, 1e-15);
  }
}

TEST(FieldsFile, KeepsEveryDigitOfTheFluence) {
  const SampleRun run(primaries);
  const auto grid = fields_of(run);
  vtkDataArray* fluence = grid->GetPointData()->GetArray("fluence");
  ASSERT_NE(fluence, nullptr);
  EXPECT_EQ(values_of(*fluence), run.solution.fluence);
  EXPECT_EQ(component_names(*fluence), primaries);
  EXPECT_EQ(unit_of(*fluence), "W/m^2");
}

TEST(FieldsFile, HasCellMeansOfTheFluence) {
  const SampleRun run({"red", "green"});
  const auto grid = fields_of(run);
  vtkDataArray* mean = grid->GetCellData()->GetArray("fluence_mean");
  ASSERT_NE(mean, nullptr);
  const std::vector<double>& f = run.solution.fluence;
  for (std::size_t c = 0; c < 6; ++c)
    for (std::size_t b = 0; b < 2; ++b)
      EXPECT_NEAR(mean->GetComponent(static_cast<vtkIdType>(c), static_cast<int>(b)),
                  (f[8 * c + b] + f[8 * c + 2 + b] + f[8 * c + 4 + b] + f[8 * c + 6 + b]) / 4, 1e-15);
}

TEST(FieldsFile, HasANetFluxVectorForEachBand) {
  const SampleRun run(primaries);
  const auto grid = fields_of(run);
  EXPECT_EQ(grid->GetPointData()->GetArray("net_flux"), nullptr);
  for (std::size_t b = 0; b < 3; ++b) {
    vtkDataArray* flux = grid->GetPointData()->GetArray(("net_flux_" + primaries[b]).c_str());
    ASSERT_NE(flux, nullptr);
    ASSERT_EQ(flux->GetNumberOfComponents(), 3);
    for (vtkIdType point = 0; point < 24; ++point)
      for (int axis = 0; axis < 3; ++axis)
        EXPECT_EQ(flux->GetComponent(point, axis),
                  run.solution.net_flux[static_cast<std::size_t>((point * 3 + axis) * 3) + b]);
  }
}

TEST(FieldsFile, NamesTheFluxOfASingleBandWithoutSuffix) {
  const SampleRun run({"grey"});
  const auto grid = fields_of(run);
  vtkDataArray* flux = grid->GetPointData()->GetArray("net_flux");
  ASSERT_NE(flux, nullptr);
  EXPECT_EQ(values_of(*flux), run.solution.net_flux);
}

TEST(FieldsFile, ShowsDisplayPrimariesAsColours) {
  const SampleRun run(primaries);
  const auto grid = fields_of(run);
  vtkDataArray* color = grid->GetPointData()->GetArray("color");
  ASSERT_NE(color, nullptr);
  EXPECT_EQ(color->GetDataType(), VTK_UNSIGNED_CHAR);
  const Exposure exposure = exposure_of(run.solution.fluence, run.mesh.volumes(), 4);
  const std::vector<std::uint8_t> expected = display_colors(run.solution.fluence, exposure);
  EXPECT_EQ(values_of(*color), std::vector<double>(expected.begin(), expected.end()));
  EXPECT_NE(unit_of(*color).find("sRGB, white = "), std::string::npos);
}

TEST(FieldsFile, HasTheUncollidedPartAndTheErrorOfDirectionsWhateverTheBands) {
  for (const std::vector<std::string>& bands : {std::vector<std::string>{"grey"}, primaries}) {
    SampleRun run(bands);
    EXPECT_EQ(fields_of(run)->GetPointData()->GetArray("fluence_uncollided"), nullptr);
    EXPECT_EQ(fields_of(run)->GetCellData()->GetArray("fluence_direction_error"), nullptr);
    run.solution.lights.fluence = run.solution.fluence;
    run.solution.direction_error.assign(6 * bands.size(), 0.1);
    const auto grid = fields_of(run);
    vtkDataArray* uncollided = grid->GetPointData()->GetArray("fluence_uncollided");
    vtkDataArray* error = grid->GetCellData()->GetArray("fluence_direction_error");
    ASSERT_NE(uncollided, nullptr);
    ASSERT_NE(error, nullptr);
    EXPECT_EQ(values_of(*uncollided), run.solution.fluence);
    EXPECT_EQ(values_of(*error), run.solution.direction_error);
    EXPECT_EQ(component_names(*error), bands);
  }
}

TEST(FieldsFile, ShowsOneBandAsGrey) {
  const SampleRun run({"grey"});
  for (const vtkSmartPointer<vtkDataSet>& data :
       {vtkSmartPointer<vtkDataSet>(fields_of(run)), vtkSmartPointer<vtkDataSet>(walls_of(run))}) {
    vtkDataArray* color = data->GetPointData()->GetArray("color");
    ASSERT_NE(color, nullptr);
    ASSERT_EQ(color->GetNumberOfComponents(), 3);
    ASSERT_EQ(color->GetNumberOfTuples(), data->GetNumberOfPoints());
    for (vtkIdType point = 0; point < data->GetNumberOfPoints(); ++point)
      for (int c = 1; c < 3; ++c) EXPECT_EQ(color->GetComponent(point, c), color->GetComponent(point, 0));
    EXPECT_GT(color->GetRange(0)[1], color->GetRange(0)[0]);
    EXPECT_EQ(unit_of(*color).find("grey: mean of the bands; sRGB, white = "), 0U) << unit_of(*color);
  }
}

TEST(FieldsFile, SaysWhereItIsFromAndInWhichUnits) {
  SampleRun run({"red", "green"}, {700, 600, 500});
  run.input.units = {.length = "cm", .power = "mW"};
  for (const vtkSmartPointer<vtkDataSet>& data :
       {vtkSmartPointer<vtkDataSet>(fields_of(run)), vtkSmartPointer<vtkDataSet>(walls_of(run))}) {
    vtkFieldData& fields = *data->GetFieldData();
    EXPECT_EQ(names_in(fields, "title"), std::vector<std::string>{"Sample"});
    EXPECT_EQ(names_in(fields, "program"), std::vector<std::string>{"etendue " + program_version()});
    const std::vector<std::string> units = names_in(fields, "units");
    EXPECT_EQ(std::ranges::count(units, "coordinates: cm"), 1);
    EXPECT_EQ(std::ranges::count(units, "net_flux_red: mW/cm^2"), 1);
    ASSERT_NE(fields.GetArray("band_edges"), nullptr);
    EXPECT_EQ(values_of(*fields.GetArray("band_edges")), (std::vector<double>{700, 600, 500}));
  }
  EXPECT_EQ(fields_of(SampleRun({"grey"}))->GetFieldData()->GetArray("band_edges"), nullptr);
}

TEST(FieldsFile, IsXmlAloneUnlessAppendedDataAreAskedFor) {
  const ScratchFolder scratch;
  SampleRun run(primaries);
  const std::filesystem::path path = scratch.path() / "fields.vtu";
  write_fields(run.result(), path, path);
  const std::string inline_text = test::text_of(path);
  EXPECT_EQ(inline_text.find("<AppendedData"), std::string::npos);
  EXPECT_TRUE(std::ranges::all_of(inline_text, [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); }));
  const std::vector<double> fluence = values_of(*fields_of(run)->GetPointData()->GetArray("fluence"));
  run.input.output.encoding = VtkEncoding::appended_raw;
  write_fields(run.result(), path, path);
  EXPECT_NE(test::text_of(path).find("<AppendedData encoding=\"raw\">"), std::string::npos);
  EXPECT_EQ(values_of(*fields_of(run)->GetPointData()->GetArray("fluence")), fluence);
}

TEST(FieldsFile, NamesRegions) {
  const SampleRun run({"grey"});
  const auto grid = fields_of(run);
  vtkDataArray* region = grid->GetCellData()->GetArray("region");
  ASSERT_NE(region, nullptr);
  for (int c = 0; c < 6; ++c) EXPECT_EQ(region->GetComponent(c, 0), run.mesh.region(CellIndex(c)));
  EXPECT_EQ(names_in(*grid->GetFieldData(), "region_names"), run.mesh.region_names());
  const std::vector<std::string> names = names_in(*grid->GetCellData(), "region_name");
  ASSERT_EQ(names.size(), 6U);
  for (std::size_t c = 0; c < 6; ++c)
    EXPECT_EQ(names[c], run.mesh.region_names()[run.mesh.cell_regions()[c] == 0 ? 0 : 1]);
}

TEST(FieldsFile, HoldsOnlyTheFieldsAskedFor) {
  SampleRun run(primaries);
  run.input.output.fields = {"media"};
  const auto grid = fields_of(run);
  EXPECT_EQ(grid->GetPointData()->GetNumberOfArrays(), 0);
  for (const char* name : {"absorption", "scattering", "emission"}) {
    vtkDataArray* array = grid->GetCellData()->GetArray(name);
    ASSERT_NE(array, nullptr) << name;
    EXPECT_EQ(component_names(*array), primaries);
  }
  EXPECT_EQ(grid->GetCellData()->GetArray("fluence_mean"), nullptr);
  EXPECT_EQ(grid->GetCellData()->GetArray("absorption")->GetComponent(0, 1),
            run.problem.absorption(CellIndex(0), 1));
}

TEST(FieldsFile, HoldsKeptOrdinates) {
  SampleRun run({"grey"});
  run.solution.radiance = {{5, run.solution.fluence}, {6, run.solution.fluence}};
  run.input.output.radiance_ordinates = {5};
  const auto grid = fields_of(run);
  vtkDataArray* radiance = grid->GetPointData()->GetArray("radiance_5");
  ASSERT_NE(radiance, nullptr);
  EXPECT_EQ(values_of(*radiance), run.solution.fluence);
  EXPECT_EQ(unit_of(*radiance), "W/(m^2 sr)");
  EXPECT_EQ(grid->GetPointData()->GetArray("radiance_6"), nullptr) << "kept for a sensor";
}

TEST(FieldsFile, HasTheSameBytesEachTime) {
  const ScratchFolder scratch;
  const SampleRun run(primaries);
  for (const char* name : {"first", "second"}) write_fields(run.result(), scratch.path() / name, name);
  EXPECT_EQ(test::text_of(scratch.path() / "first"), test::text_of(scratch.path() / "second"));
}

TEST(FieldsFile, SaysWhyItCannotBeWritten) {
  const SampleRun run({"grey"});
  try {
    write_fields(run.result(), "/nowhere/fields.vtu", "results/fields.vtu");
    FAIL() << "written";
  } catch (const FileError& error) {
    EXPECT_EQ(std::string(error.what()).rfind("results/fields.vtu: cannot be written (", 0), 0U)
        << error.what();
  }
}

TEST(WallsFile, KeepsWhatArrivesAndLeaves) {
  const SampleRun run({"red", "green"});
  const auto surface = walls_of(run);
  ASSERT_EQ(surface->GetNumberOfCells(), 12);
  ASSERT_EQ(surface->GetNumberOfPoints(), 36);
  vtkPointData* data = surface->GetPointData();
  EXPECT_EQ(values_of(*data->GetArray("irradiance")), run.solution.irradiance);
  EXPECT_EQ(values_of(*data->GetArray("exitance")), run.solution.exitance);
  EXPECT_EQ(data->GetArray("net_irradiance")->GetComponent(0, 0),
            run.solution.irradiance[0] - run.solution.exitance[0]);
  EXPECT_EQ(unit_of(*data->GetArray("exitance")), "W/m^2");
}

TEST(WallsFile, HasNetFluxVectorsOfTheSameLayoutAsFields) {
  for (const std::vector<std::string>& bands : {std::vector<std::string>{"grey"}, primaries}) {
    const SampleRun run(bands);
    const auto surface = walls_of(run);
    const auto grid = fields_of(run);
    for (std::size_t b = 0; b < bands.size(); ++b) {
      const std::string name = bands.size() == 1 ? "net_flux" : "net_flux_" + bands[b];
      vtkDataArray* flux = surface->GetPointData()->GetArray(name.c_str());
      ASSERT_NE(flux, nullptr) << name;
      ASSERT_NE(grid->GetPointData()->GetArray(name.c_str()), nullptr) << name;
      EXPECT_EQ(component_names(*flux), component_names(*grid->GetPointData()->GetArray(name.c_str())));
      ASSERT_EQ(flux->GetNumberOfTuples(), 36);
      for (vtkIdType point = 0; point < 36; ++point) {
        const auto at = static_cast<std::size_t>(point) * bands.size() + b;
        const double net = run.solution.irradiance[at] - run.solution.exitance[at];
        const Vec3 normal = run.mesh.area_normal(FaceIndex(static_cast<int>(point / 3))).normalized();
        EXPECT_LT((Vec3(flux->GetTuple(point)) - net * normal).norm(), 1e-14);
      }
    }
  }
}

TEST(WallsFile, NamesWalls) {
  const SampleRun run({"grey"});
  const auto surface = walls_of(run);
  vtkDataArray* wall = surface->GetCellData()->GetArray("wall");
  ASSERT_NE(wall, nullptr);
  for (int f = 0; f < 12; ++f) EXPECT_EQ(wall->GetComponent(f, 0), run.mesh.wall(FaceIndex(f)));
  EXPECT_EQ(names_in(*surface->GetFieldData(), "wall_names"), run.mesh.wall_names());
  const std::vector<std::string> names = names_in(*surface->GetCellData(), "wall_name");
  ASSERT_EQ(names.size(), 12U);
  for (int f = 0; f < 12; ++f)
    EXPECT_EQ(names[static_cast<std::size_t>(f)],
              run.mesh.wall_names()[static_cast<std::size_t>(run.mesh.wall(FaceIndex(f)))]);
}

TEST(WallsFile, HasTrianglesThatFaceOutwards) {
  const SampleRun run({"grey"});
  const auto surface = walls_of(run);
  for (int f = 0; f < 12; ++f) {
    const std::vector<Vec3> p = corners_of(*surface->GetCell(f));
    const Vec3 area_normal = (p[1] - p[0]).cross(p[2] - p[0]) / 2;
    EXPECT_LT((area_normal - run.mesh.area_normal(FaceIndex(f))).norm(), 1e-15);
  }
}

TEST(WallsFile, ShowsDisplayPrimariesAsColours) {
  const auto surface = walls_of(SampleRun(primaries));
  ASSERT_NE(surface->GetPointData()->GetArray("color"), nullptr);
  EXPECT_EQ(surface->GetPointData()->GetArray("color")->GetDataType(), VTK_UNSIGNED_CHAR);
}

TEST(DirectionsFile, HasEveryDirectionWithItsWeight) {
  const ScratchFolder scratch;
  const std::filesystem::path path = scratch.path() / "set.vtp";
  const DirectionSet set = directions_thurgood(2);
  write_directions(set, Case{}, path);
  const auto points = read_back<vtkXMLPolyDataReader, vtkPolyData>(path);
  ASSERT_EQ(points->GetNumberOfPoints(), 32);
  EXPECT_EQ(points->GetNumberOfVerts(), 32);
  for (int m = 0; m < set.count(); ++m) {
    EXPECT_EQ(Vec3(points->GetPoint(m)), set.direction(OrdinateIndex(m)));
    EXPECT_EQ(points->GetPointData()->GetArray("weight")->GetTuple1(m), set.weight(OrdinateIndex(m)));
    EXPECT_EQ(points->GetPointData()->GetArray("ordinate")->GetTuple1(m), m);
  }
}

}  // namespace
}  // namespace etendue::vtk_files_test
