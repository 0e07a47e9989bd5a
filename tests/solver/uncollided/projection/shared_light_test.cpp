// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "solver/uncollided/lights/light_setup.h"
#include "tests/solver/transport/sample_problems.h"
#include "tests/support/thread_ranks.h"

namespace etendue::shared_light_test {
namespace {

/// A cube with a ball, in a medium that scatters by direction, under a sky of three beams, a lamp and a wall
/// that shines.
Problem lit_cube(const TetrahedralMesh& mesh, const std::vector<double>& rise) {
  const std::vector<Medium> media(mesh.region_names().size(),
                                  uniform_medium(1, 0.3, 1, 0, PhaseHenyeyGreenstein{0.6}));
  std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(1, 0, 0.3, 0));
  std::vector<int> top;
  for (std::size_t wall = 0; wall < walls.size(); ++wall) {
    walls[wall].name = mesh.wall_names()[wall];
    if (walls[wall].name == "zmax") top.push_back(static_cast<int>(wall));
    if (walls[wall].name != "xmin") continue;
    walls[wall].radiance = {1};
    walls[wall].uncollided = Uncollided::yes;
  }
  PointLight lamp;
  lamp.position = {0.11, 0.15, 0.62};
  lamp.power = {1};
  std::vector<Light> lights = {{"lamp", lamp, {}}};
  for (const double x : rise)
    lights.push_back({"sky", BeamLight{Vec3(x, 0.1, -1).normalized(), {0.3}, top, 0.4}, {}});
  return Problem(mesh, Bands{}, media, walls, AngularSpace::sphere, lights);
}

TEST(SharedLight, HasTheBitsOfOneProcess) {
  const TetrahedralMesh mesh = cube_with_ball(2e-2);
  const Problem problem = lit_cube(mesh, {-0.4, 0, 0.5});
  const LightSetup lights(problem);
  ASSERT_EQ(lights.sources().size(), 3u);
  const UncollidedField alone = uncollided_field(lights.paths(), lights.sources(), 1);
  ASSERT_FALSE(alone.collisions.empty());
  for (const int ranks : {2, 3}) {
    test::ThreadRanks group(ranks);
    group.run([&](RankGroup& own) {
      const UncollidedField shared = uncollided_field(lights.paths(), lights.sources(), 1, {}, &own);
      EXPECT_EQ(shared.fluence, alone.fluence);
      EXPECT_EQ(shared.net_flux, alone.net_flux);
      EXPECT_EQ(shared.irradiance, alone.irradiance);
      EXPECT_EQ(shared.collided, alone.collided);
      for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
        const CellIndex cell(c);
        ASSERT_TRUE(
            std::ranges::equal(shared.collisions.directions_at(cell), alone.collisions.directions_at(cell)));
        for (std::size_t k = 0; k < alone.collisions.directions_at(cell).size(); ++k)
          ASSERT_TRUE(
              std::ranges::equal(shared.collisions.values(cell, k), alone.collisions.values(cell, k)));
      }
    });
  }
}

}  // namespace
}  // namespace etendue::shared_light_test
