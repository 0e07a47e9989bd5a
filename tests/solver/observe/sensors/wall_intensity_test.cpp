// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/sensors/wall_intensity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/uncollided/first_collision/solve_split.h"
#include "tests/solver/observe/sensors/block_mesh.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::wall_intensity_test {
namespace {

using std::numbers::pi;

TetrahedralMesh box_with_a_window() {
  return block_mesh({{{0, 0.5, 1}, {0, 0.5, 1}, {0, 0.5, 1}}},
                    [](const Vec3&, const Vec3& out) { return out.z() < -0.5 ? "window" : "side"; });
}

GridReading intensity_of(const Problem& problem, int azimuths, int polar_angles, int threads = 1) {
  const DirectionSet directions = directions_product(2);
  const SolveOptions options = tight_options();
  const LightSetup lights(problem);
  const Solution solution = solve_split(lights, directions, options);
  const RayRadiance scene(lights, directions, options, solution.state, 1);
  int window = 0;
  while (problem.mesh().wall_names()[static_cast<std::size_t>(window)] != "window") ++window;
  return wall_intensity(lights, scene, window, azimuths, polar_angles, threads);
}

// In a furnace of radiance u the window is a Lambertian lamp: I = u A cos.
TEST(WallIntensity, OfAFurnaceIsLambertian) {
  const TetrahedralMesh mesh = box_with_a_window();
  const Problem furnace =
      uniform_problem(mesh, uniform_medium(1, 0.7, 2, 0.7 * 4), uniform_wall(1, 0.3 * 4, 0.7, 0));
  const GridReading found = intensity_of(furnace, 4, 4);
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 4; ++j)
      EXPECT_NEAR(found.collided[static_cast<std::size_t>(4 * k + j)], 4 * std::cos(polar_angle(k, 4)), 1e-5);
  EXPECT_EQ(intensity_of(furnace, 4, 4, 3).collided, found.collided);
}

// A bulb of 4 pi W sends 1 W/sr; what the window lets out is that, attenuated on the path.
TEST(WallIntensity, HasTheBulbsThatAreSeenThroughTheWindow) {
  const TetrahedralMesh mesh = box_with_a_window();
  std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(1, 0, 0, 0));
  const Problem lamp(mesh, {}, {uniform_medium(1, 0.5, 0, 0)}, walls, AngularSpace::sphere,
                     {{"bulb", PointLight{{0.5, 0.4, 0.3}, {4 * pi}, Vec3::UnitZ(), {}, {}}, {}}});
  const GridReading found = intensity_of(lamp, 8, 10);
  EXPECT_NEAR(found.uncollided[0], std::exp(-0.5 * 0.3), 1e-12);
  // At 40 degrees all around it goes out at the side of the foot, 0.3 tan 40 = 0.25 from it; at 70 it does
  // not.
  for (std::size_t j = 0; j < 8; ++j) {
    EXPECT_NEAR(found.uncollided[4 * 8 + j], std::exp(-0.5 * 0.3 / std::cos(40 * pi / 180)), 1e-12);
    EXPECT_EQ(found.uncollided[7 * 8 + j], 0);
  }
}

// A lamp that is left to the directions is no source of beams, wherever it stands among the lights.
TEST(WallIntensity, HasNoBulbsThatAreLeftToTheDirections) {
  const TetrahedralMesh mesh = box_with_a_window();
  std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(1, 0, 0, 0));
  const Problem lamps(
      mesh, {}, {uniform_medium(1, 0.5, 0, 0)}, walls, AngularSpace::sphere,
      {{"left", PointLight{{0.3, 0.4, 0.6}, {40 * pi}, Vec3::UnitZ(), {}, {}}, {}, Uncollided::no},
       {"bulb", PointLight{{0.5, 0.4, 0.3}, {4 * pi}, Vec3::UnitZ(), {}, {}}, {}}});
  const GridReading found = intensity_of(lamps, 8, 10);
  EXPECT_NEAR(found.uncollided[0], std::exp(-0.5 * 0.3), 1e-12);
  EXPECT_EQ(found.uncollided[7 * 8], 0);
}

TEST(WallIntensity, AnglesAreThoseOfTheWall) {
  const TetrahedralMesh mesh = box_with_a_window();
  int window = 0;
  while (mesh.wall_names()[static_cast<std::size_t>(window)] != "window") ++window;
  const WallFrame frame(mesh, window);
  EXPECT_NEAR((frame.direction(0, 1) + Vec3::UnitZ()).norm(), 0, 1e-15);
  EXPECT_NEAR((frame.direction(pi / 2, 0) - Vec3::UnitX()).norm(), 0, 1e-15);
  // Counterclockwise from outside, that is from below: towards -y.
  EXPECT_NEAR((frame.direction(pi / 2, pi / 2) + Vec3::UnitY()).norm(), 0, 1e-15);
  EXPECT_NEAR(polar_angle(18, 19), pi / 2, 1e-15);
  EXPECT_NEAR(azimuth_angle(6, 24), pi / 2, 1e-15);
}

}  // namespace
}  // namespace etendue::wall_intensity_test
