// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Penumbras on walls of few large faces: as much arrives as is sent, and as much at each wall as the visible
// part of the light sends there.
#include <gtest/gtest.h>

#include <numbers>
#include <numeric>
#include <string>

#include "solver/uncollided/lights/light_setup.h"
#include "solver/uncollided/visibility/occluding_edges.h"
#include "tests/solver/transport/sample_problems.h"
#include "tests/solver/uncollided/obstacle_room.h"
#include "tests/solver/uncollided/visible_part.h"

namespace etendue::penumbra_test {
namespace {

/// In vacuum between black walls.
std::vector<double> power_of_faces(const TetrahedralMesh& mesh, const Light& light) {
  const Problem problem(mesh, {}, {uniform_medium(1, 0, 0, 0)},
                        std::vector<Wall>(mesh.wall_names().size(), uniform_wall(1, 0, 0, 0)),
                        AngularSpace::sphere, {light});
  const LightSetup lights(problem);
  const UncollidedField field = uncollided_field(lights.paths(), lights.sources(), 1);
  std::vector<double> power(field.irradiance.size() / 3, 0);
  for (std::size_t i = 0; i < field.irradiance.size(); ++i)
    power[i / 3] += field.irradiance[i] * mesh.area(FaceIndex(static_cast<std::int64_t>(i / 3))) / 3;
  return power;
}

double power_of_wall(const TetrahedralMesh& mesh, const std::vector<double>& power, const std::string& name) {
  double sum = 0;
  for (std::size_t f = 0; f < power.size(); ++f)
    if (mesh.wall_names()[static_cast<std::size_t>(mesh.wall(FaceIndex(static_cast<std::int64_t>(f))))] ==
        name)
      sum += power[f];
  return sum;
}

/// By midpoints, without the part of the error that falls with their square.
template <class Function>
double integral_over_unit_square(const Function& function) {
  const auto by_midpoints = [&](int count) {
    double sum = 0;
    for (int i = 0; i < count; ++i)
      for (int j = 0; j < count; ++j) sum += function((i + 0.5) / count, (j + 0.5) / count);
    return sum / (count * count);
  };
  const double coarse = by_midpoints(64), fine = by_midpoints(128);
  return fine + (fine - coarse) / 3;
}

class Penumbra : public testing::TestWithParam<Obstacle> {};

void expect_what_visible_part_sends(Obstacle obstacle, const std::vector<Vec3>& rim, double max_volume) {
  const HalfHiddenLight known(rim, corners_of(obstacle));
  const double sent = std::numbers::pi * known.area();
  const double floor = integral_over_unit_square([&](double x, double y) {
    return known.seen_from({x, y, 0}, 0).irradiance;
  });
  const TetrahedralMesh mesh = room_with(obstacle, max_volume);
  const std::vector<double> power = power_of_faces(mesh, flat_light(rim));
  EXPECT_NEAR(std::accumulate(power.begin(), power.end(), 0.0) / sent, 1, 5e-4);
  EXPECT_NEAR((power_of_wall(mesh, power, "zmin") - floor) / sent, 0, 2e-4);
  for (const std::string axis : {"x", "y"})
    EXPECT_NEAR(power_of_wall(mesh, power, axis + "min") / sent,
                power_of_wall(mesh, power, axis + "max") / sent, 2e-4)
        << axis;
}

TEST_P(Penumbra, BringsWhatTheVisiblePartSends) {
  for (const auto& rim : {rectangle(0.25, 0.2), rectangle(0.04, 0.3)})
    for (const double max_volume : {5e-2, 1e-2}) expect_what_visible_part_sends(GetParam(), rim, max_volume);
}

TEST(PenumbraOfADisc, BringsWhatTheVisiblePartSends) {
  expect_what_visible_part_sends(Obstacle::sheet, disc(0.2), 5e-2);
}

INSTANTIATE_TEST_SUITE_P(Obstacles, Penumbra, testing::Values(Obstacle::box, Obstacle::sheet),
                         [](const auto& of) { return of.param == Obstacle::box ? "box" : "sheet"; });

TEST(OccludingEdges, ReachIntoAHullOrPassBesideIt) {
  const std::vector<Vec3> hull = {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_TRUE(reaches_into({-1, -1, 0.5}, {1, 1, 0.5}, hull, 0));
  EXPECT_TRUE(reaches_into({0.2, 0.2, 0.4}, {0.3, 0.3, 0.6}, hull, 0));
  EXPECT_TRUE(reaches_into({0.7, 0.2, 0.5}, {0.2, 0.7, 0.5}, hull, 0));
  EXPECT_FALSE(reaches_into({0.8, 0.25, 0.5}, {0.25, 0.8, 0.5}, hull, 0));
  EXPECT_FALSE(reaches_into({-1, -1, 1.1}, {1, 1, 1.1}, hull, 0));
  EXPECT_FALSE(reaches_into({-1, 0.1, -0.5}, {-0.1, 0.1, 2}, hull, 0));
  // Along a side and an edge.
  EXPECT_FALSE(reaches_into({0.1, 0.1, 1}, {0.4, 0.4, 1}, hull, 1e-9));
  EXPECT_FALSE(reaches_into({0, 0, 0.2}, {0, 0, 0.8}, hull, 1e-9));
}

}  // namespace
}  // namespace etendue::penumbra_test
