// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/files/fields/field_file.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>

#include "base/errors.h"
#include "mesh/files/mesh_file.h"
#include "tests/mesh/files/scratch_folder.h"
#include "tests/mesh/tetrahedra/sample_meshes.h"

namespace etendue::field_file_test {
namespace {

std::string problem_of(const FieldRequest& request) {
  try {
    read_field(request);
    return "";
  } catch (const InputError& error) {
    return error.what();
  } catch (const FileError& error) {
    return error.what();
  }
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// 2 x 1 x 1 voxels: kappa in both, a vector, a text, and temperatures at the 12 points.
const std::string image = R"(<?xml version="1.0"?>
<VTKFile type="ImageData" version="1.0">
<ImageData WholeExtent="1 3 0 1 0 1" Origin="10 0 0" Spacing="0.5 2 3">
<Piece Extent="1 3 0 1 0 1">
<PointData><DataArray type="Float64" Name="T" format="ascii">0 1 2 3 4 5 6 7 8 9 10 11</DataArray></PointData>
<CellData>
<DataArray type="Float64" Name="kappa" format="ascii">0.25 0.5</DataArray>
<DataArray type="Float64" Name="v" NumberOfComponents="3" format="ascii">1 2 3 4 5 6</DataArray>
<Array type="String" Name="s" format="ascii">97 0 98 0</Array>
</CellData></Piece></ImageData></VTKFile>
)";

/// A cube of one hexahedron.
const std::string hexahedron = R"(<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="1.0"><UnstructuredGrid><Piece NumberOfPoints="8" NumberOfCells="1">
<PointData><DataArray type="Float64" Name="T" format="ascii">0 1 3 2 4 5 7 6</DataArray></PointData>
<CellData><DataArray type="Int32" Name="kappa" format="ascii">3</DataArray></CellData>
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">
0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1</DataArray></Points>
<Cells><DataArray type="Int64" Name="connectivity" format="ascii">0 1 2 3 4 5 6 7</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">8</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">12</DataArray></Cells>
</Piece></UnstructuredGrid></VTKFile>
)";

double volume_of(const FieldData& field) {
  double volume = 0;
  for (const auto& cell : field.cells) {
    std::array<Vec3, 4> p;
    for (std::size_t i = 0; i < 4; ++i) p[i] = field.points[static_cast<std::size_t>(cell[i])];
    volume += std::abs((p[1] - p[0]).cross(p[2] - p[0]).dot(p[3] - p[0])) / 6;
  }
  return volume;
}

TEST(FieldFile, ReadsCellsAndPointsOfAnImage) {
  const ScratchFolder folder;
  const auto path = folder.write("i.vti", image);
  const FieldData cells = read_field({path, "kappa"});
  ASSERT_TRUE(cells.image);
  EXPECT_EQ(cells.on, FieldValues::on_cells);
  EXPECT_EQ(cells.values, (std::vector<double>{0.25, 0.5}));
  EXPECT_EQ(cells.image->points, (std::array{3, 2, 2}));
  EXPECT_EQ(cells.image->origin, Vec3(10.5, 0, 0));
  EXPECT_EQ(Vec3(cells.image->steps.diagonal()), Vec3(0.5, 2, 3));
  const FieldData points = read_field({path, "T"});
  EXPECT_EQ(points.on, FieldValues::on_points);
  EXPECT_EQ(points.values.size(), 12U);
  EXPECT_EQ(read_field({.path = path, .array = "v", .component = 1}).values, (std::vector<double>{2, 5}));
}

TEST(FieldFile, CutsCellsIntoTetrahedra) {
  const ScratchFolder folder;
  const auto path = folder.write("h.vtu", hexahedron);
  const FieldData cells = read_field({path, "kappa"});
  EXPECT_GE(cells.cells.size(), 5U);
  EXPECT_NEAR(volume_of(cells), 1, 1e-14);
  EXPECT_EQ(cells.values, std::vector<double>(cells.cells.size(), 3.0));
  const FieldData points = read_field({path, "T"});
  ASSERT_EQ(points.values.size(), points.points.size());
  for (std::size_t p = 0; p < points.points.size(); ++p)
    EXPECT_EQ(points.values[p], points.points[p].dot(Vec3(1, 2, 4)));
}

TEST(FieldFile, SaysWhichArraysThereAre) {
  const ScratchFolder folder;
  const auto path = folder.write("i.vti", image);
  EXPECT_TRUE(
      has(problem_of({path, "kapa"}), "i.vti: holds no array \"kapa\"; on cells: kappa, v, s; on points: T"))
      << problem_of({path, "kapa"});
  EXPECT_TRUE(has(problem_of({path, "kappa", FieldValues::on_points}), "holds no point array"));
  EXPECT_TRUE(has(problem_of({path, ""}), "holds several arrays or none; choose one"));
  EXPECT_TRUE(has(problem_of({path, "v"}), "has 3 components; choose one by `component`, from 0 to 2"));
  EXPECT_TRUE(has(problem_of({.path = path, .array = "v", .component = 3}), "has no component 3"));
  EXPECT_TRUE(has(problem_of({path, "s"}), "holds no numbers"));
}

TEST(FieldFile, RefusesFilesThatAreMissingCutShortOrOfAnotherKind) {
  const ScratchFolder folder;
  EXPECT_TRUE(has(problem_of({folder.path() / "none.vti", "kappa"}), "none.vti: cannot be opened"));
  for (const double part : {0.0, 0.2, 0.5, 0.7, 0.9}) {
    const auto length = [part](const std::string& text) {
      return text.substr(0, static_cast<std::size_t>(part * static_cast<double>(text.size())));
    };
    EXPECT_NE(problem_of({folder.write("i.vti", length(image)), "kappa"}), "") << part;
    EXPECT_NE(problem_of({folder.write("h.vtu", length(hexahedron)), "kappa"}), "") << part;
  }
  EXPECT_TRUE(has(problem_of({folder.write("a.csv", "1"), "kappa"}), "is not the name of a field"));
  std::string lost = hexahedron;
  lost.replace(lost.find("4 5 6 7</"), 9, "4 5 6 9</");
  EXPECT_TRUE(
      has(problem_of({folder.write("l.vtu", lost), "kappa"}), "point 9.000000 does not exist; there are 8"));
}

/// A 348 byte header (NIfTI-1) of 2 x 2 x 2 voxels of 16 bit with this spacing, and the values 1 … 8.
std::string nifti(float spacing) {
  std::string bytes(352, '\0');
  const auto put = [&bytes](std::size_t at, auto value) { std::memcpy(&bytes[at], &value, sizeof value); };
  put(0, std::int32_t{348});
  const std::int16_t dimensions[8] = {3, 2, 2, 2, 1, 1, 1, 1};
  for (std::size_t i = 0; i < 8; ++i) put(40 + 2 * i, dimensions[i]);
  put(70, std::int16_t{4});   // signed short
  put(72, std::int16_t{16});  // bits
  for (std::size_t i = 0; i < 4; ++i) put(76 + 4 * i, i == 0 ? 1.0F : spacing);
  put(108, 352.0F);  // where the values begin
  put(112, 1.0F);    // slope
  std::memcpy(&bytes[344], "n+1", 4);
  for (std::int16_t value = 1; value <= 8; ++value)
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  return bytes;
}

TEST(FieldFile, TakesNiftiValuesAsThoseOfVoxels) {
  const ScratchFolder folder;
  const FieldData field = read_field({.path = folder.write("head.nii", nifti(0.5F)), .array = ""});
  ASSERT_TRUE(field.image);
  EXPECT_EQ(field.on, FieldValues::on_cells);
  EXPECT_EQ(field.image->points, (std::array{3, 3, 3}));
  EXPECT_EQ(Vec3(field.image->steps.diagonal().cwiseAbs()), Vec3(0.5, 0.5, 0.5));
  EXPECT_EQ(field.values, (std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8}));
}

TEST(FieldFile, PlacesNiftiVoxelsByTheSformAndRescalesTheirValues) {
  std::string bytes = nifti(0.5F);
  const auto put = [&bytes](std::size_t at, auto value) { std::memcpy(&bytes[at], &value, sizeof value); };
  put(112, 2.0F);  // slope
  put(116, 3.0F);  // intercept
  put(254, std::int16_t{1});
  // Rows of the sform: x = 0.5 j + 10, y = -0.5 i + 20, z = 0.5 k + 30.
  const float rows[12] = {0, 0.5F, 0, 10, -0.5F, 0, 0, 20, 0, 0, 0.5F, 30};
  for (std::size_t i = 0; i < 12; ++i) put(280 + 4 * i, rows[i]);
  const ScratchFolder folder;
  const FieldData field = read_field({.path = folder.write("head.nii", bytes), .array = ""});
  EXPECT_EQ(field.values, (std::vector<double>{5, 7, 9, 11, 13, 15, 17, 19}));
  ASSERT_TRUE(field.image);
  EXPECT_NEAR((field.image->steps.col(0) - Vec3(0, -0.5, 0)).norm(), 0, 1e-6);
  EXPECT_NEAR((field.image->steps.col(1) - Vec3(0.5, 0, 0)).norm(), 0, 1e-6);
  // The first voxel's middle is at (10, 20, 30).
  EXPECT_NEAR((field.image->origin - Vec3(9.75, 20.25, 29.75)).norm(), 0, 1e-5);
}

/// An OpenFOAM case of one cubic cell, with T at the times 0 and 2.5.
void write_open_foam(const ScratchFolder& folder) {
  const auto header = [](const std::string& kind, const std::string& object) {
    return "FoamFile { version 2.0; format ascii; class " + kind + "; object " + object + "; }\n";
  };
  for (const char* name : {"system", "constant/polyMesh", "0", "2.5"})
    std::filesystem::create_directories(folder.path() / name);
  folder.write("system/controlDict", header("dictionary", "controlDict") +
                                         "startTime 0; endTime 5; deltaT 2.5; writeControl timeStep; "
                                         "writeInterval 1;\n");
  folder.write(
      "constant/polyMesh/points",
      header("vectorField", "points") + "8((0 0 0)(1 0 0)(1 1 0)(0 1 0)(0 0 1)(1 0 1)(1 1 1)(0 1 1))\n");
  folder.write(
      "constant/polyMesh/faces",
      header("faceList", "faces") + "6(4(0 3 2 1) 4(4 5 6 7) 4(0 1 5 4) 4(3 7 6 2) 4(0 4 7 3) 4(1 2 6 5))\n");
  folder.write("constant/polyMesh/owner", header("labelList", "owner") + "6(0 0 0 0 0 0)\n");
  folder.write("constant/polyMesh/neighbour", header("labelList", "neighbour") + "0()\n");
  folder.write("constant/polyMesh/boundary",
               header("polyBoundaryMesh", "boundary") + "1(walls{type wall; nFaces 6; startFace 0;})\n");
  for (const auto& [time, value] : {std::pair("0", "300"), std::pair("2.5", "900")})
    folder.write(std::string(time) + "/T", header("volScalarField", "T") +
                                               "dimensions [0 0 0 1 0 0 0];\ninternalField uniform " + value +
                                               ";\nboundaryField{walls{type zeroGradient;}}\n");
}

TEST(FieldFile, ReadsOpenFoamAtItsLastTimeOrAnother) {
  const ScratchFolder folder;
  write_open_foam(folder);
  const FieldData last = read_field({folder.path(), "T"});
  EXPECT_NEAR(volume_of(last), 1, 1e-14);
  EXPECT_EQ(last.values, std::vector<double>(last.cells.size(), 900.0));
  const FieldData first = read_field({.path = folder.path(), .array = "T", .time = 0});
  EXPECT_EQ(first.values, std::vector<double>(first.cells.size(), 300.0));
  EXPECT_TRUE(has(problem_of({.path = folder.path(), .array = "T", .time = 1}), "holds no time 1"));
  EXPECT_TRUE(has(problem_of({folder.path(), "U"}), "holds no array \"U\"; on cells: T"))
      << problem_of({folder.path(), "U"});
  std::filesystem::remove(folder.path() / "constant/polyMesh/faces");
  EXPECT_NE(problem_of({folder.path(), "T"}), "");
  const ScratchFolder empty;
  EXPECT_NE(problem_of({empty.path(), "T"}), "");
}

}  // namespace
}  // namespace etendue::field_file_test
