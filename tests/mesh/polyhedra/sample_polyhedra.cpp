// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/mesh/polyhedra/sample_polyhedra.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <numbers>
#include <string>

#include "base/position.h"
#include "mesh/polyhedra/match_faces.h"

namespace etendue::sample_polyhedra {
namespace {

/// Numbers of the points and cells of a box.
struct BoxNumbers {
  std::array<int, 3> cells;

  int point(int i, int j, int k) const { return i + (cells[0] + 1) * (j + (cells[1] + 1) * k); }
  int cell(const std::array<int, 3>& at) const { return at[0] + cells[0] * (at[1] + cells[1] * at[2]); }
  bool has(const std::array<int, 3>& at) const {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (at[axis] < 0 || at[axis] >= cells[axis]) return false;
    return true;
  }
  /// The face of a cell at the low (0) or high (1) end of an axis, seen from outside.
  std::array<int, 4> face(const std::array<int, 3>& at, std::size_t axis, int end) const {
    std::array<int, 4> points{};
    constexpr std::array<std::array<int, 2>, 4> round = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    for (std::size_t corner = 0; corner < 4; ++corner) {
      std::array<int, 3> place = at;
      place[axis] += end;
      const std::array<int, 2>& step = round[end == 1 ? corner : 3 - corner];
      place[(axis + 1) % 3] += step[0];
      place[(axis + 2) % 3] += step[1];
      points[corner] = point(place[0], place[1], place[2]);
    }
    return points;
  }
  template <class Use>
  void for_each(const Use& use) const {
    for (int k = 0; k < cells[2]; ++k)
      for (int j = 0; j < cells[1]; ++j)
        for (int i = 0; i < cells[0]; ++i) use(std::array<int, 3>{i, j, k});
  }
};

void add_face(PolyhedralMesh& mesh, std::span<const int> points, int owner, int neighbor, int wall) {
  mesh.face_points.insert(mesh.face_points.end(), points.begin(), points.end());
  mesh.face_ends.push_back(static_cast<int>(mesh.face_points.size()));
  mesh.owners.push_back(owner);
  mesh.neighbors.push_back(neighbor);
  mesh.face_walls.push_back(wall);
}

std::ofstream foam_stream(const std::filesystem::path& path, const std::string& type) {
  std::ofstream file(path);
  file << std::setprecision(17)
       << "/* A test. */\nFoamFile\n{\n    version 2.0;\n    format ascii;\n    class " << type
       << ";\n    object " << path.filename().string() << ";\n}\n// * * * //\n\n";
  return file;
}

void write_labels(const std::filesystem::path& path, const std::vector<int>& labels) {
  std::ofstream file = foam_stream(path, "labelList");
  file << labels.size() << "\n(\n";
  for (const int label : labels) file << label << '\n';
  file << ")\n";
}

void write_boundary(const std::filesystem::path& path, const PolyhedralMesh& mesh) {
  std::ofstream file = foam_stream(path, "polyBoundaryMesh");
  file << mesh.wall_names.size() << "\n(\n";
  for (std::size_t w = 0; w < mesh.wall_names.size(); ++w) {
    int first = -1, count = 0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
      if (mesh.face_walls[f] == static_cast<int>(w) && count++ == 0) first = static_cast<int>(f);
    file << "    " << mesh.wall_names[w] << "\n    {\n        type " << mesh.patch_types[w]
         << ";\n        inGroups 1(wall);\n        nFaces " << count << ";\n        startFace " << first
         << ";\n    }\n";
  }
  file << ")\n";
}

/// Cells of the region "domain" are in no zone.
void write_zones(const std::filesystem::path& path, const PolyhedralMesh& mesh) {
  if (mesh.region_names == std::vector<std::string>{"domain"}) return;
  std::ofstream file = foam_stream(path, "regIOobject");
  file << std::ranges::count_if(mesh.region_names, [](const auto& name) { return name != "domain"; })
       << "\n(\n";
  for (std::size_t r = 0; r < mesh.region_names.size(); ++r) {
    if (mesh.region_names[r] == "domain") continue;
    file << mesh.region_names[r] << "\n{\n    type cellZone;\n    cellLabels List<label>\n"
         << std::ranges::count(mesh.cell_regions, static_cast<int>(r)) << "\n(\n";
    for (std::size_t c = 0; c < mesh.cell_count(); ++c)
      if (mesh.cell_regions[c] == static_cast<int>(r)) file << c << '\n';
    file << ")\n;\n}\n";
  }
  file << ")\n";
}

}  // namespace

PolyhedralMesh hexahedra(const std::array<int, 3>& cells, const Vec3& size) {
  const BoxNumbers box{cells};
  PolyhedralMesh mesh;
  for (int k = 0; k <= cells[2]; ++k)
    for (int j = 0; j <= cells[1]; ++j)
      for (int i = 0; i <= cells[0]; ++i)
        mesh.points.emplace_back(size.x() * i / cells[0], size.y() * j / cells[1], size.z() * k / cells[2]);
  mesh.cell_regions.assign(position(cells[0] * cells[1] * cells[2]), 0);
  mesh.region_names = {"domain"};
  mesh.wall_names = {"xmin", "xmax", "ymin", "ymax", "zmin", "zmax"};
  mesh.patch_types = {"wall", "wall", "wall", "wall", "patch", "wall"};
  box.for_each([&](std::array<int, 3> at) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::array<int, 3> next = at;
      ++next[axis];
      if (box.has(next)) add_face(mesh, box.face(at, axis, 1), box.cell(at), box.cell(next), -1);
    }
  });
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const int end : {0, 1})
      box.for_each([&](std::array<int, 3> at) {
        if (at[axis] == (end == 0 ? 0 : cells[axis] - 1))
          add_face(mesh, box.face(at, axis, end), box.cell(at), -1, static_cast<int>(2 * axis) + end);
      });
  return mesh;
}

PolyhedralMesh single_cell(std::vector<Vec3> points, const std::vector<std::vector<int>>& faces) {
  PolyhedralMesh mesh;
  mesh.points = std::move(points);
  mesh.cell_regions = {0};
  mesh.region_names = {"domain"};
  mesh.wall_names = {"boundary"};
  Polygons of_cells;
  for (const std::vector<int>& face : faces) of_cells.add(0, face);
  Polygons of_walls = of_cells;
  match_faces(of_cells, of_walls, mesh);
  return mesh;
}

PolyhedralMesh prism() {
  return single_cell({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}},
                     {{0, 1, 2}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}});
}

PolyhedralMesh pyramid() {
  return single_cell({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}},
                     {{0, 1, 2, 3}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
}

PolyhedralMesh tetrahedron() {
  return single_cell({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                     {{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
}

PolyhedralMesh hexagonal_prism() {
  std::vector<Vec3> points;
  for (const double z : {0.0, 1.0})
    for (int i = 0; i < 6; ++i)
      points.emplace_back(std::cos(i * std::numbers::pi / 3), std::sin(i * std::numbers::pi / 3), z);
  std::vector<std::vector<int>> faces = {{0, 1, 2, 3, 4, 5}, {6, 7, 8, 9, 10, 11}};
  for (int i = 0; i < 6; ++i) faces.push_back({i, (i + 1) % 6, (i + 1) % 6 + 6, i + 6});
  return single_cell(points, faces);
}

PolyhedralMesh truncated_cube() {
  return single_cell({{0, 0, 0},
                      {1, 0, 0},
                      {1, 1, 0},
                      {0, 1, 0},
                      {0, 0, 1},
                      {1, 0, 1},
                      {0, 1, 1},
                      {1, 1, 0.5},
                      {0.5, 1, 1},
                      {1, 0.5, 1}},
                     {{0, 3, 2, 1},
                      {0, 1, 5, 4},
                      {0, 4, 6, 3},
                      {1, 2, 7, 9, 5},
                      {3, 6, 8, 7, 2},
                      {4, 5, 9, 8, 6},
                      {7, 8, 9}});
}

PolyhedralMesh cube_of_nine_faces() {
  return single_cell({{0, 0, 0},
                      {0.5, 0, 0},
                      {1, 0, 0},
                      {0, 0.5, 0},
                      {0.5, 0.5, 0},
                      {1, 0.5, 0},
                      {0, 1, 0},
                      {0.5, 1, 0},
                      {1, 1, 0},
                      {0, 0, 1},
                      {1, 0, 1},
                      {1, 1, 1},
                      {0, 1, 1}},
                     {{0, 1, 4, 3},
                      {1, 2, 5, 4},
                      {3, 4, 7, 6},
                      {4, 5, 8, 7},
                      {9, 10, 11, 12},
                      {0, 1, 2, 10, 9},
                      {2, 5, 8, 11, 10},
                      {8, 7, 6, 12, 11},
                      {6, 3, 0, 9, 12}});
}

void write_foam_mesh(const std::filesystem::path& folder, const PolyhedralMesh& mesh) {
  const std::filesystem::path files = folder / "constant" / "polyMesh";
  std::filesystem::create_directories(files);
  std::ofstream points = foam_stream(files / "points", "vectorField");
  points << mesh.points.size() << "\n(\n";
  for (const Vec3& point : mesh.points)
    points << '(' << point.x() << ' ' << point.y() << ' ' << point.z() << ")\n";
  points << ")\n";
  std::ofstream faces = foam_stream(files / "faces", "faceList");
  faces << mesh.face_count() << "\n(\n";
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    faces << mesh.face(f).size() << '(';
    for (std::size_t i = 0; i < mesh.face(f).size(); ++i) faces << (i == 0 ? "" : " ") << mesh.face(f)[i];
    faces << ")\n";
  }
  faces << ")\n";
  std::vector<int> inside;
  for (const int neighbor : mesh.neighbors)
    if (neighbor >= 0) inside.push_back(neighbor);
  write_labels(files / "owner", mesh.owners);
  write_labels(files / "neighbour", inside);
  write_boundary(files / "boundary", mesh);
  write_zones(files / "cellZones", mesh);
}

}  // namespace etendue::sample_polyhedra
