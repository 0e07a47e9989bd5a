// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Lights of every kind in a room with a crate: as much is taken as is sent, and the same in metres as in
// millimetres and in a domain of micrometres, where the same coordinates are rounded otherwise.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "mesh/geometry/arrangement/arrangement.h"
#include "mesh/tetrahedra/generation/tetrahedralize.h"
#include "solver/uncollided/lights/light_setup.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::scale_test {
namespace {

RawMesh room_with_crate() {
  Geometry geometry;
  BoxPrimitive room, crate;
  room.region = "air";
  room.max = {1, 0.8, 0.6};
  crate.min = {0.4, 0.3, 0};
  crate.max = {0.6, 0.5, 0.2};
  crate.hole = true;
  crate.name = "crate";
  geometry.primitives.emplace_back(room);
  geometry.primitives.emplace_back(crate);
  return tetrahedralize(arrange(geometry), {{2e-3}, 1.4, {}});
}

/// One that shines as a spot does, or all around if it has no angles.
Light lamp(double scale, const std::vector<double>& degrees, const std::vector<double>& intensity) {
  PointLight light;
  light.position = scale * Vec3(0.5, 0.4, 0.5);
  light.power = {1};
  light.axis = Vec3(0.1, 0.1, -0.5).normalized();
  for (const double angle : degrees) light.angle.push_back(angle * std::numbers::pi / 180);
  light.intensity = intensity;
  return {"lamp", light, {}};
}

Light square(double scale) {
  SurfaceLight light{{}, {1 / (scale * scale)}};
  const double low = 0.36 * scale, high = 0.64 * scale, z = 0.55 * scale;
  const Vec3 a(low, low, z), b(low, high, z), c(high, high, z), d(high, low, z);
  light.triangles = {a, b, c, a, c, d};
  return {"square", light, {}};
}

Light sun(double scale, const TetrahedralMesh& mesh) {
  BeamLight light{Vec3(0.3, 0.2, -0.8).normalized(), {1 / (scale * scale)}, {}};
  for (const char* side : {"xmin", "ymin", "zmax"})
    light.walls.push_back(
        static_cast<int>(std::ranges::find(mesh.wall_names(), side) - mesh.wall_names().begin()));
  return {"sun", light, {}};
}

Light light_of(const std::string& kind, double scale, const TetrahedralMesh& mesh) {
  if (kind == "point") return lamp(scale, {}, {});
  if (kind == "spot") return lamp(scale, {0, 15, 25}, {1, 1, 0});
  if (kind == "sharp_spot") return lamp(scale, {0, 25}, {1, 1});
  return kind == "square" ? square(scale) : sun(scale, mesh);
}

/// Parts of what is sent: [cell] that the medium takes and [face] that black walls take.
struct Taken {
  std::vector<double> by_cells, by_faces;
  double missing = 1;
};

Taken light_taken(RawMesh raw, const std::string& kind, double scale) {
  for (Vec3& point : raw.points) point *= scale;
  const TetrahedralMesh mesh(raw);
  const Problem problem(mesh, {}, {uniform_medium(1, 1 / scale, 0, 0)},
                        std::vector<Wall>(mesh.wall_names().size(), uniform_wall(1, 0, 0, 0)),
                        AngularSpace::sphere, {light_of(kind, scale, mesh)});
  const LightSetup lights(problem);
  const UncollidedField field = uncollided_field(lights.paths(), lights.sources(), 1);
  const double sent = lights.sources()[0]->power()[0];
  Taken taken;
  for (std::size_t c = 0; c < field.fluence.size() / 4; ++c) {
    double mean = 0;
    for (std::size_t i = 0; i < 4; ++i) mean += field.fluence[4 * c + i] / 4;
    taken.by_cells.push_back(mean * mesh.volumes()[c] / scale / sent);
    taken.missing -= taken.by_cells.back();
  }
  for (std::size_t f = 0; f < field.irradiance.size() / 3; ++f) {
    double mean = 0;
    for (std::size_t i = 0; i < 3; ++i) mean += field.irradiance[3 * f + i] / 3;
    taken.by_faces.push_back(mean * mesh.area(FaceIndex(static_cast<std::int64_t>(f))) / sent);
    taken.missing -= taken.by_faces.back();
  }
  return taken;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

class LightOfAnyScale : public testing::TestWithParam<std::string> {};

TEST_P(LightOfAnyScale, IsTheSame) {
  const RawMesh mesh = room_with_crate();
  const Taken one = light_taken(mesh, GetParam(), 1);
  for (const double scale : {1024.0, 1000.0, 7.0, 3.0, 1e-6}) {
    const Taken other = light_taken(mesh, GetParam(), scale);
    const double rounding = scale == 1024 ? 0 : 1e-6;
    EXPECT_LE(largest_difference(one.by_cells, other.by_cells), rounding) << scale;
    EXPECT_LE(largest_difference(one.by_faces, other.by_faces), rounding) << scale;
  }
}

TEST_P(LightOfAnyScale, Balances) {
  const double missing = std::abs(light_taken(room_with_crate(), GetParam(), 1).missing);
  // The edge of a sharp cone is cut along chords; of a square cells that it shines through hold a jump.
  EXPECT_LT(missing, GetParam() == "square" ? 1e-3 : GetParam() == "sharp_spot" ? 2e-5 : 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Kinds, LightOfAnyScale,
                         testing::Values("point", "spot", "sharp_spot", "square", "sun"),
                         [](const auto& of) { return of.param; });

}  // namespace
}  // namespace etendue::scale_test
