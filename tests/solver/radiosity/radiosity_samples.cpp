// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/solver/radiosity/radiosity_samples.h"

#include <numbers>

#include "mesh/geometry/arrangement/arrangement.h"
#include "mesh/tetrahedra/generation/tetrahedralize.h"

namespace etendue {

Problem empty_room(const TetrahedralMesh& mesh, double reflectance, const std::string& bright) {
  std::vector<Medium> media;
  for (const std::string& name : mesh.region_names()) {
    Medium medium;
    medium.name = name;
    medium.absorption = medium.scattering = medium.emission = {Coefficient(0)};
    medium.phase = {PhaseIsotropic{}};
    medium.origin = {"room.toml", 3, "media." + name};
    media.push_back(std::move(medium));
  }
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    Wall wall;
    wall.name = name;
    wall.radiance = {name == bright ? 1 / std::numbers::pi : 0};
    wall.diffuse = {reflectance};
    wall.specular = {0};
    wall.origin = {"room.toml", 5, "walls." + name};
    walls.push_back(std::move(wall));
  }
  return Problem(mesh, Bands{}, std::move(media), std::move(walls));
}

TetrahedralMesh room_with_crate(double max_volume) {
  Geometry geometry;
  BoxPrimitive room;
  room.region = "air";
  geometry.primitives.emplace_back(room);
  BoxPrimitive crate;
  crate.hole = true;
  crate.name = "crate";
  crate.min = Vec3(0.3, 0.3, 0.3);
  crate.max = Vec3(0.6, 0.7, 0.6);
  geometry.primitives.emplace_back(crate);
  const SurfaceComplex surface = arrange(geometry);
  return TetrahedralMesh(tetrahedralize(surface, {{max_volume}, 1.4, {}}));
}

double mean_on(const TetrahedralMesh& mesh, const std::vector<double>& values, const std::string& wall) {
  double sum = 0, area = 0;
  for (int f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    if (mesh.wall_names()[static_cast<std::size_t>(mesh.wall(face))] != wall) continue;
    area += mesh.area(face);
    for (std::size_t i = 0; i < 3; ++i) sum += mesh.area(face) / 3 * values[3 * face.at() + i];
  }
  return sum / area;
}

}  // namespace etendue
