// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/camera/gather.h"

#include <gtest/gtest.h>

#include <numbers>

#include "solver/transport/solve/solve.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::gather_test {
namespace {

// The bottom of a cubic well under a uniform sky: in its corners 0.138531605995 pi arrive (closed form of the
// factor between parallel squares). The rays start 2 % of a face beside the corner, which is worth 1 %, and
// the edges of the sky cut through the parts that they stand for.
TEST(Gather, FindsTheSkyFromTheCornersOfAWell) {
  const TetrahedralMesh mesh(kuhn_cube_raw());
  std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(1, 0, 0, 0));
  for (std::size_t w = 0; w < walls.size(); ++w) {
    walls[w].name = mesh.wall_names()[w];
    if (walls[w].name == "zmax") walls[w].radiance = {1};
    if (walls[w].name == "zmin") walls[w].diffuse = {0.5};
  }
  const Problem well(mesh, {}, {uniform_medium(1, 0, 0, 0)}, walls);
  const LightSetup lights(well);
  ASSERT_TRUE(lights.empty());
  const DirectionSet directions = directions_product(2);
  const SolveOptions options = tight_options();
  const Solution solution = solve(well, directions, options);
  const RayRadiance scene(lights, directions, options, solution.state, 1);
  const WallIrradiance gathered = gather(scene, 1024, 16, 1);
  int corners = 0;
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const bool bottom = mesh.wall_names()[static_cast<std::size_t>(mesh.wall(FaceIndex(f)))] == "zmin";
    for (std::size_t i = 0; i < 3; ++i, corners += bottom ? 1 : 0) {
      const double value = gathered.values[static_cast<std::size_t>(f) * 3 + i];
      if (bottom)
        EXPECT_NEAR(value, 0.138531605995 * std::numbers::pi, 0.03 * 0.1385 * std::numbers::pi);
      else
        EXPECT_EQ(value, 0) << "nobody asks what black walls receive";
    }
  }
  EXPECT_EQ(corners, 6);
  EXPECT_TRUE(gather(scene, 0, 16, 1).values.empty());
  double seen = 0;
  EXPECT_EQ(gather(scene, 64, 16, 1, [&](double share) { return seen = share, true; }).values.size(),
            gathered.values.size());
  EXPECT_EQ(seen, 1);
  EXPECT_TRUE(gather(scene, 64, 16, 1, [](double) { return false; }).values.empty()) << "it was stopped";
}

}  // namespace
}  // namespace etendue::gather_test
