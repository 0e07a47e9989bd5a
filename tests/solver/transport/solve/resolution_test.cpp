// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/solve/resolution.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/angular/sets/direction_set.h"
#include "solver/transport/cells/cell_coefficients.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::resolution_test {
namespace {

using std::numbers::pi;

Resolution found_for(const TetrahedralMesh& mesh, const Medium& medium, const Light& light) {
  const Problem problem(mesh, {}, {medium},
                        std::vector<Wall>(mesh.wall_names().size(), uniform_wall(1, 0, 0, 0)),
                        AngularSpace::sphere, {light});
  return resolution_of(problem, directions_ldfe_sq(1), CellLocator(mesh));
}

Light lamp(const Vec3& position) {
  PointLight light;
  light.position = position;
  light.power = {1};
  return {"lamp", light, {}};
}

TEST(Resolution, IsThatOfTheCells) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  const Vec3 place = mesh.centroid(CellIndex(7));
  const Resolution found =
      found_for(mesh, uniform_medium(1, 1, 9, 0, PhaseHenyeyGreenstein{0.9}), lamp(place));
  double largest = 0;
  for (const double volume : mesh.volumes()) largest = std::max(largest, 10 * cell_size(volume));
  EXPECT_NEAR(found.largest_thickness, largest, 1e-12);
  EXPECT_GT(found.median_thickness, 0.2 * largest);
  EXPECT_LT(found.median_thickness, largest);
  // sigma_a + (1 - g) sigma_s = 1.9
  EXPECT_NEAR(found.transport_thickness_at_lights, 1.9 * cell_size(mesh.volume(CellIndex(7))), 1e-12);
  EXPECT_NEAR(found.direction_spacing, std::sqrt(4 * pi / 96), 1e-12);
  ASSERT_TRUE(found.narrowest);
  EXPECT_EQ(found.narrowest->region, mesh.region_names()[0]);
}

TEST(Resolution, IsNoMatterOfAVacuumNorOfWidePhaseFunctions) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  const Resolution vacuum =
      found_for(mesh, uniform_medium(1, 0, 0, 0, PhaseHenyeyGreenstein{0.9}), lamp({0.5, 0.5, 0.5}));
  EXPECT_EQ(vacuum.largest_thickness, 0);
  EXPECT_EQ(vacuum.transport_thickness_at_lights, 0);
  EXPECT_FALSE(vacuum.narrowest);
  EXPECT_FALSE(found_for(mesh, uniform_medium(1, 0, 1, 0), lamp({0.5, 0.5, 0.5})).narrowest);
}

}  // namespace
}  // namespace etendue::resolution_test
