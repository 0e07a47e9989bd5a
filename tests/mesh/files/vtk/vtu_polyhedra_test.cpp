// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <sstream>
#include <vector>

#include "tests/mesh/files/read_message.h"
#include "tests/mesh/files/scratch_folder.h"

namespace etendue::vtu_polyhedra_test {
namespace {

struct VtuCell {
  int type = 0;
  std::vector<int> points;
  std::vector<std::vector<int>> faces = {};  ///< of a polyhedron
};

std::string array_of(const std::string& type, const std::string& name, const std::vector<int>& values) {
  std::ostringstream text;
  text << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" format=\"ascii\">";
  for (const int value : values) text << value << ' ';
  text << "</DataArray>\n";
  return text.str();
}

/// A grid of VTK as text, with cell arrays.
std::string vtu(const std::vector<Vec3>& points, const std::vector<VtuCell>& cells,
                const std::string& cell_data = "") {
  std::ostringstream text;
  text << "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
          "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n"
       << "<Piece NumberOfPoints=\"" << points.size() << "\" NumberOfCells=\"" << cells.size()
       << "\">\n<CellData>" << cell_data
       << "</CellData>\n<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n";
  for (const Vec3& point : points) text << point.x() << ' ' << point.y() << ' ' << point.z() << '\n';
  std::vector<int> connectivity, offsets, types, faces, face_offsets;
  bool has_polyhedra = false;
  for (const VtuCell& cell : cells) {
    connectivity.insert(connectivity.end(), cell.points.begin(), cell.points.end());
    offsets.push_back(static_cast<int>(connectivity.size()));
    types.push_back(cell.type);
    if (cell.faces.empty()) {
      face_offsets.push_back(-1);
      continue;
    }
    has_polyhedra = true;
    faces.push_back(static_cast<int>(cell.faces.size()));
    for (const std::vector<int>& face : cell.faces) {
      faces.push_back(static_cast<int>(face.size()));
      faces.insert(faces.end(), face.begin(), face.end());
    }
    face_offsets.push_back(static_cast<int>(faces.size()));
  }
  text << "</DataArray></Points>\n<Cells>\n"
       << array_of("Int64", "connectivity", connectivity) << array_of("Int64", "offsets", offsets)
       << array_of("UInt8", "types", types);
  if (has_polyhedra)
    text << array_of("Int64", "faces", faces) << array_of("Int64", "faceoffsets", face_offsets);
  text << "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  return text.str();
}

const std::vector<Vec3> cube = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
constexpr int tetra = 10, voxel = 11, hexahedron = 12, wedge = 13, pyramid_type = 14, quad = 9,
              hexagonal = 16, polyhedron = 42;

double volume_in(const std::string& text) {
  const ScratchFolder folder;
  const TetrahedralMesh mesh(read_mesh(folder.write("m.vtu", text)));
  double sum = 0;
  for (const double volume : mesh.volumes()) sum += volume;
  return sum;
}

std::string message_of(const std::string& text) {
  const ScratchFolder folder;
  return read_message(folder.write("m.vtu", text));
}

TEST(VtuPolyhedra, AreReadOfEachKind) {
  EXPECT_NEAR(volume_in(vtu(cube, {{hexahedron, {0, 1, 2, 3, 4, 5, 6, 7}}})), 1, 1e-14);
  EXPECT_NEAR(volume_in(vtu(cube, {{voxel, {0, 1, 3, 2, 4, 5, 7, 6}}})), 1, 1e-14);
  EXPECT_NEAR(volume_in(vtu(cube, {{wedge, {0, 1, 3, 4, 5, 7}}})), 0.5, 1e-14);
  EXPECT_NEAR(volume_in(vtu(cube, {{pyramid_type, {0, 1, 2, 3, 4}}})), 1.0 / 3, 1e-14);
  std::vector<Vec3> points;
  for (const double z : {0, 1})
    for (const auto& [x, y] :
         std::vector<std::pair<double, double>>{{0, 0}, {1, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 1}})
      points.emplace_back(x, y, z);
  EXPECT_NEAR(volume_in(vtu(points, {{hexagonal, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}}})), 3, 1e-14);
}

TEST(VtuPolyhedra, MayHaveFacesInAnyDirection) {
  const std::vector<std::vector<int>> faces = {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                               {6, 5, 1, 2}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  EXPECT_NEAR(volume_in(vtu(cube, {{polyhedron, {0, 1, 2, 3, 4, 5, 6, 7}, faces}})), 1, 1e-14);
}

TEST(VtuPolyhedra, StandBesideTetrahedraInTheOrderOfTheFile) {
  std::vector<Vec3> points = cube;
  points.emplace_back(0.5, 0.5, 2);
  points.emplace_back(0.5, 0.5, 3);
  const std::string text = vtu(points,
                               {{tetra, {4, 5, 8, 9}},
                                {quad, {0, 1, 2, 3}},
                                {hexahedron, {0, 1, 2, 3, 4, 5, 6, 7}},
                                {pyramid_type, {4, 5, 6, 7, 8}}},
                               array_of("Int32", "region", {7, 0, 5, 7}));
  const ScratchFolder folder;
  const RawMesh raw = read_mesh(folder.write("m.vtu", text), 2);
  EXPECT_EQ(raw.region_names, (std::vector<std::string>{"7", "5"}));
  ASSERT_EQ(raw.cells.size(), 1U + 12 + 6);
  EXPECT_EQ(raw.parents.cells.front(), 0);
  EXPECT_EQ(raw.parents.cells[1], 1);
  EXPECT_EQ(raw.parents.cells.back(), 2);
  EXPECT_EQ(raw.points[6], Vec3(2, 2, 2));
}

TEST(VtuPolyhedra, HaveTheWallsOfPolygons) {
  const std::vector<std::vector<int>> sides = {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                               {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  std::vector<VtuCell> cells = {{hexahedron, {0, 1, 2, 3, 4, 5, 6, 7}}};
  for (const std::vector<int>& side : sides) cells.push_back({quad, side});
  const ScratchFolder folder;
  const TetrahedralMesh mesh(
      read_mesh(folder.write("m.vtu", vtu(cube, cells, array_of("Int32", "wall", {-1, 3, 4, 8, 8, 8, 8})))));
  EXPECT_EQ(mesh.wall_names(), (std::vector<std::string>{"3", "4", "8"}));
  for (int f = 0; f < mesh.boundary_face_count(); ++f) {
    const double z = mesh.centroid(FaceIndex(f)).z();
    EXPECT_EQ(mesh.wall_names()[static_cast<std::size_t>(mesh.wall(FaceIndex(f)))], z < 1e-9       ? "3"
                                                                                    : z > 1 - 1e-9 ? "4"
                                                                                                   : "8");
  }
  cells[1].points = {0, 1, 2, 7};
  EXPECT_EQ(
      message_of(vtu(cube, cells, array_of("Int32", "wall", {-1, 3, 4, 8, 8, 8, 8}))),
      "m.vtu: polygon of points 0 1 2 7 of wall \"3\" is no face of a cell; walls must be faces of the mesh");
}

TEST(VtuPolyhedra, ThatCannotBeAreRefused) {
  EXPECT_EQ(message_of(vtu(cube, {{hexahedron, {0, 1, 2, 3, 4, 5, 6}}})),
            "m.vtu: cell 0: has 7 points; must have 8");
  EXPECT_EQ(message_of(vtu(cube, {{wedge, {0, 1, 3, 4, 5, 70}}})),
            "m.vtu: cell 0: point 70 does not exist; there are 8");
  EXPECT_NE(message_of(vtu(cube, {{hexahedron, {0, 1, 3, 2, 4, 5, 6, 7}}}))
                .find("m.vtu: cell 0 at (0.5, 0.5, 0.5): "),
            std::string::npos);
  const std::vector<std::vector<int>> open = {
      {0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}};
  EXPECT_NE(message_of(vtu(cube, {{polyhedron, {0, 1, 2, 3, 4, 5, 6, 7}, open}}))
                .find("its faces do not enclose it"),
            std::string::npos);
  const std::vector<std::vector<int>> wild = {{0, 1, 2, 300}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}};
  EXPECT_EQ(message_of(vtu(cube, {{polyhedron, {0, 1, 2, 3, 4, 5, 6, 7}, wild}})).find("m.vtu: "), 0U);
}

}  // namespace
}  // namespace etendue::vtu_polyhedra_test
