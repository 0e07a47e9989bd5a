// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "solver/solution/balance.h"
#include "solver/uncollided/first_collision/solve_split.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::thick_cells_test {
namespace {

// Slab of optical thickness 20 and albedo 0.99 in a beam straight on: parts of its power, by adding and
// doubling with 64 levels in each hemisphere.
constexpr double exact_reflected = 0.752354, exact_transmitted = 0.014818;

/// Unit cube between mirrors, lit from below.
Problem slab(const TetrahedralMesh& mesh) {
  const Medium medium = uniform_medium(1, 0.2, 19.8, 0);
  std::vector<Wall> walls;
  int lit = -1;
  for (const std::string& name : mesh.wall_names()) {
    const bool open = name == "zmin" || name == "zmax";
    if (name == "zmin") lit = static_cast<int>(walls.size());
    walls.push_back(uniform_wall(1, 0, 0, open ? 0 : 1));
    walls.back().name = name;
  }
  const Light sun{"sun", BeamLight{Vec3(0, 0, 1), {1}, {lit}}, {}};
  return Problem(mesh, {}, std::vector<Medium>(mesh.region_names().size(), medium), walls,
                 AngularSpace::sphere, {sun});
}

// The beam ends within the first cells, of up to seven free paths. Where the mass is lumped, values at
// vertices in place of integrals would move its first collisions out of the slab: R of 0.996 and T of -0.009
// on these cells.
TEST(ThickCells, ScatterABeamWhereItIsAttenuated) {
  const TetrahedralMesh mesh = cube_mesh(0.005);
  const Problem problem = slab(mesh);
  for (const Lumping lumping : {Lumping::none, Lumping::mass}) {
    SolveOptions options = tight_options();
    options.lumping = lumping;
    const Solution solution = solve_split(LightSetup(problem), directions_double_gauss(4), options);
    ASSERT_TRUE(solution.converged());
    const auto powers = wall_powers(problem, solution);
    ASSERT_EQ(powers.size(), mesh.wall_names().size());
    for (std::size_t wall = 0; wall < powers.size(); ++wall) {
      const double arriving = powers[wall][0].incoming;
      if (mesh.wall_names()[wall] == "zmin") {
        EXPECT_NEAR(arriving, exact_reflected, 0.01);
      }
      if (mesh.wall_names()[wall] == "zmax") {
        EXPECT_NEAR(arriving, exact_transmitted, 0.003);
      }
    }
  }
}

}  // namespace
}  // namespace etendue::thick_cells_test
