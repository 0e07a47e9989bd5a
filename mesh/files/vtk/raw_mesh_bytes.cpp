// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/files/vtk/raw_mesh_bytes.h"

#include <string>

#include "base/array_bytes.h"

namespace etendue {
namespace {

using Place = std::array<double, 3>;

void write_names(std::FILE* file, const std::vector<std::string>& names) {
  write_array(file, std::vector<std::size_t>{names.size()});
  for (const std::string& name : names) write_array(file, std::vector<char>(name.begin(), name.end()));
}

std::vector<std::string> take_names(std::string_view& bytes) {
  std::vector<std::string> names;
  for (std::size_t left = take_value<std::size_t>(bytes); left > 0; --left) {
    const std::vector<char> letters = take_array<char>(bytes);
    names.emplace_back(letters.begin(), letters.end());
  }
  return names;
}

void write_points(std::FILE* file, const std::vector<Vec3>& points) {
  std::vector<Place> places;
  places.reserve(points.size());
  for (const Vec3& point : points) places.push_back({point.x(), point.y(), point.z()});
  write_array(file, places);
}

std::vector<Vec3> take_points(std::string_view& bytes) {
  std::vector<Vec3> points;
  for (const auto& [x, y, z] : take_array<Place>(bytes)) points.emplace_back(x, y, z);
  return points;
}

}  // namespace

void write_raw_mesh(std::FILE* file, const RawMesh& mesh) {
  write_points(file, mesh.points);
  write_array(file, mesh.cells);
  write_array(file, mesh.cell_regions);
  write_array(file, mesh.triangles);
  write_array(file, mesh.triangle_walls);
  write_array(file, mesh.cell_numbers);
  write_names(file, mesh.region_names);
  write_names(file, mesh.wall_names);
}

RawMesh take_raw_mesh(std::string_view bytes) {
  RawMesh mesh;
  mesh.points = take_points(bytes);
  mesh.cells = take_array<std::array<int, 4>>(bytes);
  mesh.cell_regions = take_array<int>(bytes);
  mesh.triangles = take_array<std::array<int, 3>>(bytes);
  mesh.triangle_walls = take_array<int>(bytes);
  mesh.cell_numbers = take_array<std::int64_t>(bytes);
  mesh.region_names = take_names(bytes);
  mesh.wall_names = take_names(bytes);
  return mesh;
}

void write_polyhedral_mesh(std::FILE* file, const PolyhedralMesh& mesh) {
  write_points(file, mesh.points);
  for (const auto* numbers : {&mesh.face_points, &mesh.face_ends, &mesh.owners, &mesh.neighbors,
                              &mesh.face_walls, &mesh.cell_regions})
    write_array(file, *numbers);
  write_names(file, mesh.region_names);
  write_names(file, mesh.wall_names);
}

PolyhedralMesh take_polyhedral_mesh(std::string_view bytes) {
  PolyhedralMesh mesh;
  mesh.points = take_points(bytes);
  for (auto* numbers : {&mesh.face_points, &mesh.face_ends, &mesh.owners, &mesh.neighbors, &mesh.face_walls,
                        &mesh.cell_regions})
    *numbers = take_array<int>(bytes);
  mesh.region_names = take_names(bytes);
  mesh.wall_names = take_names(bytes);
  return mesh;
}

}  // namespace etendue
