// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Shadows of a black box and of an opaque sheet: dark without exception where nothing of the light is seen,
// and beside that as bright as what is seen of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/uncollided/lights/light_setup.h"
#include "tests/solver/transport/sample_problems.h"
#include "tests/solver/uncollided/obstacle_room.h"
#include "tests/solver/uncollided/visible_part.h"

namespace etendue::shadow_test {
namespace {

using std::numbers::pi;

/// A light that is so small that it is wholly seen or not at all.
std::vector<Vec3> speck(const Vec3& at, double size) {
  return {at + Vec3(size, 0, 0), at + Vec3(0, size, 0), at - Vec3(size, size, 0)};
}

Light bulb(const Vec3& position) {
  PointLight light;
  light.position = position;
  light.power = {1};
  return {"bulb", light, {}};
}

/// By the walls of the room alone: what it comes in by hides nothing.
Light sun(const Vec3& direction, const TetrahedralMesh& mesh) {
  BeamLight light{direction, {1}, {}};
  for (const char* side : {"xmin", "xmax", "ymin", "ymax", "zmin", "zmax"})
    light.walls.push_back(
        static_cast<int>(std::ranges::find(mesh.wall_names(), side) - mesh.wall_names().begin()));
  return {"sun", light, {}};
}

class Scene {
 public:
  Scene(const TetrahedralMesh& mesh, double extinction, const Light& light)
      : problem_(mesh, {}, {uniform_medium(1, extinction, 0, 0)},
                 std::vector<Wall>(mesh.wall_names().size(), uniform_wall(1, 0, 0, 0)), AngularSpace::sphere,
                 {light}),
        lights_(problem_),
        locator_(mesh) {}

  LightAtPoint at(const Vec3& place) const {
    return lights_.at({locator_.find(place).front().cell, place}, Vec3::UnitZ());
  }
  /// Cut along the edges of what stands in the way.
  VisibleLight cut_at(const Vec3& place) const {
    const LightAtPoint light = at(place);
    return {light.fluence[0], light.irradiance[0]};
  }
  /// With the light in parts whose sides fill at most so many radians.
  VisibleLight at(const Vec3& place, double largest_side) const {
    LightBeams beams(1);
    lights_.sources()[0]->add_beams({locator_.find(place).front().cell, place}, Sight::attenuated,
                                    {0, 0, fine_light.thickness, largest_side, fine_light.rule}, beams);
    VisibleLight sum;
    for (std::size_t i = 0; i < beams.size(); ++i) {
      sum.fluence += beams.fluence(i)[0];
      sum.irradiance += beams.fluence(i)[0] * std::max(0.0, -beams.direction(i).z());
    }
    return sum;
  }

  UncollidedField field() const { return uncollided_field(lights_.paths(), lights_.sources(), 1); }

 private:
  Problem problem_;
  LightSetup lights_;
  CellLocator locator_;
};

/// Points below the obstacle.
std::vector<Vec3> grid(int count) {
  std::vector<Vec3> points;
  for (const double z : {0.02, 0.3})
    for (int i = 0; i < count; ++i)
      for (int j = 0; j < count; ++j) points.emplace_back((i + 0.37) / count, (j + 0.41) / count, z);
  return points;
}

/// Whether nothing is seen of the light from just below a place.
bool is_dark(const HalfHiddenLight& light, const Vec3& place) {
  return place.z() < obstacle_low.z() + 1e-9 && light.visible_area(place - Vec3(0, 0, 1e-6)) == 0;
}

/// The umbra is convex, so what has all its corners in it lies in it.
template <class Vertices>
bool is_dark(const HalfHiddenLight& light, const TetrahedralMesh& mesh, const Vertices& vertices) {
  return std::ranges::all_of(vertices,
                             [&](std::int32_t v) { return is_dark(light, mesh.point(VertexIndex(v))); });
}

void expect_darkness(const TetrahedralMesh& mesh, const Light& light, const HalfHiddenLight& known) {
  const Scene scene(mesh, 1.5, light);
  int points = 0, cells = 0, faces = 0;
  for (const Vec3& place : grid(12)) {
    if (!is_dark(known, place)) continue;
    ++points;
    EXPECT_EQ(scene.at(place).fluence[0], 0.0) << light.name << " " << place.transpose();
    EXPECT_EQ(scene.at(place).irradiance[0], 0.0) << light.name << " " << place.transpose();
  }
  const UncollidedField field = scene.field();
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    if (!is_dark(known, mesh, mesh.vertices(CellIndex(c)))) continue;
    ++cells;
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(field.fluence[4 * CellIndex(c).at() + i], 0.0);
    for (std::size_t i = 0; i < 12; ++i) EXPECT_EQ(field.net_flux[12 * CellIndex(c).at() + i], 0.0);
  }
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    if (mesh.wall_names()[static_cast<std::size_t>(mesh.wall(FaceIndex(f)))] == "top" ||
        !is_dark(known, mesh, mesh.vertices(FaceIndex(f))))
      continue;
    ++faces;
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(field.irradiance[3 * FaceIndex(f).at() + i], 0.0);
  }
  EXPECT_GT(points, 5) << light.name;
  EXPECT_GT(cells, 5) << light.name;
  EXPECT_GT(faces, 3) << light.name;
}

class Umbra : public ::testing::TestWithParam<Obstacle> {
 protected:
  TetrahedralMesh mesh = room_with(GetParam(), 2e-3);
  std::vector<Vec3> corners = corners_of(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Shadow, Umbra, ::testing::Values(Obstacle::box, Obstacle::sheet));

TEST_P(Umbra, OfABulbIsDark) {
  const Vec3 position(0.47, 0.52, 0.85);
  expect_darkness(mesh, bulb(position), {speck(position, 1e-9), corners});
}

TEST_P(Umbra, OfTheSunIsDark) {
  const Vec3 direction = Vec3(0.2, -0.1, -1).normalized();
  expect_darkness(mesh, sun(direction, mesh), {speck(obstacle_low - 1e7 * direction, 1e-3), corners});
}

TEST_P(Umbra, OfARectangleIsDark) {
  const auto rim = rectangle(0.2, 0.15);
  expect_darkness(mesh, flat_light(rim), {rim, corners});
}

TEST_P(Umbra, OfADiscIsDark) {
  const auto rim = disc(0.2, 12);
  expect_darkness(mesh, flat_light(rim), {rim, corners});
}

// On a line across the shadow's edge on the side of the box at high x: a bulb and the sun have no penumbra.
TEST(Shadow, OfABulbAndOfTheSunEndsAtAnEdge) {
  const TetrahedralMesh mesh = room_with(Obstacle::box, 4e-3);
  constexpr double extinction = 1.5, height = 0.1, near = 1e-9;
  const Vec3 position(0.47, 0.52, 0.85), direction = Vec3(-0.2, 0, -1).normalized();
  const Scene by_bulb(mesh, extinction, bulb(position)), by_sun(mesh, extinction, sun(direction, mesh));
  const double slope = -direction.z();
  const double of_bulb = position.x() + (obstacle_high.x() - position.x()) * (position.z() - height) /
                                            (position.z() - obstacle_high.z());
  const double of_sun = obstacle_high.x() - 0.2 * (obstacle_low.z() - height);
  EXPECT_EQ(by_bulb.at({of_bulb - near, 0.5, height}).fluence[0], 0.0);
  EXPECT_EQ(by_sun.at({of_sun - near, 0.5, height}).fluence[0], 0.0);
  const Vec3 lit_by_bulb(of_bulb + near, 0.5, height);
  const double r = (lit_by_bulb - position).norm(), fluence = std::exp(-extinction * r) / (4 * pi * r * r);
  const LightAtPoint beside = by_bulb.at(lit_by_bulb);
  EXPECT_NEAR(beside.fluence[0] / fluence, 1, 1e-12);
  EXPECT_NEAR(beside.irradiance[0] / (fluence * (position.z() - height) / r), 1, 1e-12);
  const LightAtPoint in_sun = by_sun.at({of_sun + near, 0.5, height});
  const double left = std::exp(-extinction * (1 - height) / slope);
  EXPECT_NEAR(in_sun.fluence[0] / left, 1, 1e-12);
  EXPECT_NEAR(in_sun.irradiance[0] / (left * slope), 1, 1e-12);
}

/// Differences from the closed form over what the whole light would bring.
struct Differences {
  int points = 0;
  double largest = 0, squares = 0;

  void add(const VisibleLight& found, const VisibleLight& known, const VisibleLight& whole) {
    const double of_fluence = (found.fluence - known.fluence) / whole.fluence;
    const double of_irradiance = (found.irradiance - known.irradiance) / whole.irradiance;
    largest = std::max({largest, std::abs(of_fluence), std::abs(of_irradiance)});
    squares += (of_fluence * of_fluence + of_irradiance * of_irradiance) / 2;
    ++points;
  }
  double root_mean_square() const { return std::sqrt(squares / points); }
};

// The integral along the sides, of which the closed forms of empty space are the limit.
TEST(VisiblePart, ThroughHardlyAnyMatterIsThatInVacuum) {
  const HalfHiddenLight light(disc(0.2), corners_of(Obstacle::box));
  for (const Vec3& place : grid(5)) {
    const VisibleLight thin = light.seen_from(place, 1e-12), none = light.seen_from(place, 0);
    EXPECT_NEAR(thin.fluence, none.fluence, 1e-10);
    EXPECT_NEAR(thin.irradiance, none.irradiance, 1e-10);
  }
}

// Where the light is seen in part its points are seen or not, and the obstacle's edge runs between about the
// root of n of them: sides of a quarter leave a fifth to a tenth of the error. What is lit wholly is off by
// the rule alone.
TEST(Shadow, PenumbraTendsToTheVisiblePartOfTheLight) {
  for (const Obstacle obstacle : {Obstacle::box, Obstacle::sheet}) {
    const TetrahedralMesh mesh = room_with(obstacle, 4e-3);
    for (const auto& rim : {rectangle(0.2, 0.15), disc(0.2)})
      for (const double extinction : {0.0, 1.5}) {
        const Scene scene(mesh, extinction, flat_light(rim));
        const HalfHiddenLight known(rim, corners_of(obstacle));
        Differences coarse, fine, cut, lit;
        for (const Vec3& place : grid(8)) {
          const double part = known.visible_area(place) / known.area();
          if (part == 0) continue;
          const VisibleLight here = known.seen_from(place, extinction);
          const VisibleLight whole = known.whole_from(place, extinction);
          if (part > 1 - 1e-12) {
            lit.add(scene.at(place, 0.25), here, whole);
            continue;
          }
          coarse.add(scene.at(place, 0.25), here, whole);
          fine.add(scene.at(place, 0.0625), here, whole);
          cut.add(scene.cut_at(place), here, whole);
        }
        EXPECT_GT(cut.points, 60);
        EXPECT_GT(lit.points, 20);
        EXPECT_LT(lit.largest, 3e-7);
        EXPECT_LT(fine.largest, 0.015);
        EXPECT_LT(fine.root_mean_square(), 0.003);
        EXPECT_LT(fine.root_mean_square(), coarse.root_mean_square() / 3);
        EXPECT_LT(cut.largest, 3e-7);
      }
  }
}

}  // namespace
}  // namespace etendue::shadow_test
