// SPDX-License-Identifier: AGPL-3.0-or-later
//
// A flat lamp smaller than the cells around it, some of which it cuts: what the medium and the walls take,
// against integrals over the directions in which the lamp sends.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "mesh/geometry/arrangement/arrangement.h"
#include "mesh/tetrahedra/generation/tetrahedralize.h"
#include "solver/uncollided/lights/light_setup.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::near_light_test {
namespace {

const Vec3 room_size(1.1, 1.2, 1.4), lamp_at(0.2511, 0.876, 0.3751);
constexpr double small = 0.01;  // side of a lamp whose light leaves as from a point

TetrahedralMesh room(double max_volume) {
  Geometry geometry;
  BoxPrimitive box;
  box.region = "air";
  box.max = room_size;
  geometry.primitives.emplace_back(box);
  return TetrahedralMesh(tetrahedralize(arrange(geometry), {{max_volume}, 1.4, {}}));
}

/// A rectangle that shines along x.
Light lamp(double along_y, double along_z) {
  SurfaceLight light{{}, {1}};
  const Vec3 y(0, along_y / 2, 0), z(0, 0, along_z / 2);
  const Vec3 a = lamp_at - y - z, b = lamp_at + y - z, c = lamp_at + y + z, d = lamp_at - y + z;
  light.triangles = {a, b, c, a, c, d};
  return {"lamp", light, {}};
}

/// Parts of what the lamp sends.
struct Taken {
  double by_medium = 0;
  std::vector<double> by_walls;  ///< [wall]
  double missing = 1;
};

Taken light_taken(const TetrahedralMesh& mesh, double absorption, const Light& light,
                  const std::vector<std::string>& mirrors) {
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names())
    walls.push_back(uniform_wall(1, 0, 0, std::ranges::count(mirrors, name) > 0 ? 0.8 : 0));
  const Problem problem(mesh, {}, {uniform_medium(1, absorption, 0, 0)}, walls, AngularSpace::sphere,
                        {light});
  const LightSetup lights(problem);
  const UncollidedField field = uncollided_field(lights.paths(), lights.sources(), 1);
  const double sent = lights.sources()[0]->power()[0];
  Taken taken;
  taken.by_walls.resize(walls.size());
  EXPECT_EQ(field.fluence.size(), 4 * mesh.volumes().size());
  for (std::size_t i = 0; i < field.fluence.size(); ++i)
    taken.by_medium += absorption * field.fluence[i] / 4 * mesh.volumes()[i / 4] / sent;
  EXPECT_EQ(field.irradiance.size(), 3 * static_cast<std::size_t>(mesh.boundary_face_count()));
  for (std::size_t i = 0; i < field.irradiance.size(); ++i) {
    const FaceIndex face(static_cast<std::int64_t>(i / 3));
    const auto wall = static_cast<std::size_t>(mesh.wall(face));
    taken.by_walls[wall] += (1 - walls[wall].specular[0]) * field.irradiance[i] / 3 * mesh.area(face) / sent;
  }
  taken.missing -= taken.by_medium;
  for (const double part : taken.by_walls) taken.missing -= part;
  return taken;
}

/// What arrives at the walls xmin, xmax, ymin, ... of the light of a point that sends as the cosine to the x
/// axis.
std::array<double, 6> sent_to_walls(double absorption) {
  constexpr int count = 1500;
  std::array<double, 6> found{};
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < count; ++k) {
      const double sine = std::sqrt((i + 0.5) / count), azimuth = 2 * std::numbers::pi * (k + 0.5) / count;
      const Vec3 direction(std::sqrt(1 - sine * sine), sine * std::cos(azimuth), sine * std::sin(azimuth));
      double path_length = HUGE_VAL;
      std::size_t wall = 0;
      for (int axis = 0; axis < 3; ++axis) {
        const bool up = direction[axis] > 0;
        const double end = ((up ? room_size[axis] : 0) - lamp_at[axis]) / direction[axis];
        if (end < path_length) {
          path_length = end;
          wall = static_cast<std::size_t>(2 * axis + (up ? 1 : 0));
        }
      }
      found[wall] += std::exp(-absorption * path_length) / (count * count);
    }
  return found;
}

class NearLight : public testing::TestWithParam<double> {};

TEST_P(NearLight, OfASmallLampArrivesWhereItIsSentTo) {
  const TetrahedralMesh mesh = room(GetParam());
  const double absorption = 0.6;
  const Taken taken = light_taken(mesh, absorption, lamp(small, small), {});
  const std::array<double, 6> sent = sent_to_walls(absorption);
  double kept = 1;
  const std::array<std::string, 6> sides = {"xmin", "xmax", "ymin", "ymax", "zmin", "zmax"};
  for (std::size_t i = 0; i < 6; ++i) {
    const auto wall = std::ranges::find(mesh.wall_names(), sides[i]) - mesh.wall_names().begin();
    EXPECT_NEAR(taken.by_walls[static_cast<std::size_t>(wall)], sent[i], 5e-4) << sides[i];
    kept -= sent[i];
  }
  EXPECT_NEAR(taken.by_medium, kept, 5e-4);
}

TEST_P(NearLight, Balances) {
  const TetrahedralMesh mesh = room(GetParam());
  EXPECT_NEAR(light_taken(mesh, 0.6, lamp(0.116, 0.217), {}).missing, 0, 5e-4);
  EXPECT_NEAR(light_taken(mesh, 20, lamp(0.116, 0.217), {}).missing, 0, 2e-3) << "cells of 8 free paths";
}

// Their common edge hides nothing.
TEST_P(NearLight, BalancesInACornerOfMirrors) {
  const TetrahedralMesh mesh = room(GetParam());
  EXPECT_NEAR(light_taken(mesh, 0.6, lamp(0.116, 0.217), {"ymin", "zmax"}).missing, 0, 5e-4);
}

INSTANTIATE_TEST_SUITE_P(Cells, NearLight, testing::Values(0.03, 0.004));

}  // namespace
}  // namespace etendue::near_light_test
