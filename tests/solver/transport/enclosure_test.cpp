// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Enclosures whose answer is known whatever the directions: constants, balances, symmetries.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/angular/sets/rotation.h"
#include "solver/solution/balance.h"
#include "solver/solution/probe.h"
#include "solver/transport/solve/solve.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::enclosure_test {
namespace {

constexpr double four_pi = 4 * std::numbers::pi;

void expect_closed_balances(const Problem& problem, const Solution& solution, double tolerance = 1e-10) {
  for (const Balance& balance : balances(problem, solution)) EXPECT_LT(std::abs(balance.residual), tolerance);
}

TEST(InfiniteMedium, MirrorsGiveSourceOverAbsorption) {
  const TetrahedralMesh mesh = cube_mesh(3e-2);
  for (const double g : {0.0, 0.6}) {
    const PhaseFunction phase = g == 0 ? PhaseFunction(PhaseIsotropic{}) : PhaseHenyeyGreenstein{g};
    const Problem problem =
        uniform_problem(mesh, uniform_medium(2, 2.4, 1.1, 1.5, phase), uniform_wall(2, 0, 0, 1));
    const Solution solution = solve(problem, directions_ldfe_sq(1), tight_options());
    ASSERT_TRUE(solution.converged());
    EXPECT_LT(largest_deviation(solution.fluence, four_pi * 1.5 / 2.4), 1e-10);
    expect_closed_balances(problem, solution);
  }
}

TEST(Furnace, RadianceIsConstantWithMirrorsDiffuseWallsScatteringAndABall) {
  const TetrahedralMesh mesh = cube_with_ball(2e-2);
  const double level = 2.5;
  std::vector<Medium> media;
  for (const std::string& name : mesh.region_names()) {
    const bool ball = name == "ball";
    const double absorption = ball ? 2.0 : 0.3;
    media.push_back(
        uniform_medium(1, absorption, ball ? 3.0 : 0.2, absorption * level, PhaseHenyeyGreenstein{0.6}));
    media.back().name = name;
  }
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(name == "xmin" ? uniform_wall(1, 0, 0, 1)
                                   : uniform_wall(1, (1 - 0.4 - 0.2) * level, 0.4, 0.2));
    walls.back().name = name;
  }
  const Problem problem(mesh, Bands{}, media, walls);
  for (const SpaceOrder order : {SpaceOrder::linear, SpaceOrder::constant}) {
    SolveOptions options = tight_options(Lumping::automatic);
    options.order = order;
    const Solution solution = solve(problem, directions_ldfe_sq(1), options);
    ASSERT_TRUE(solution.converged());
    EXPECT_LT(largest_deviation(solution.fluence, four_pi * level), 1e-10);
    for (const double flux : solution.net_flux) EXPECT_LT(std::abs(flux), 1e-9 * level);
    expect_closed_balances(problem, solution);
  }
}

TEST(Furnace, RadianceIsConstantWhereAbsorptionDependsOnThePlace) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  Medium medium = uniform_medium(1, 0, 0.4, 0);
  medium.absorption = {Coefficient(Expression("0.2 + 9*x^2*y", {"x", "y", "z"}))};
  medium.blackbody = {Coefficient(Expression("2.5", {"x", "y", "z"}))};
  const Problem problem = uniform_problem(mesh, medium, uniform_wall(1, 0.6 * 2.5, 0.4, 0));
  const Solution solution = solve(problem, directions_ldfe_sq(1), tight_options(Lumping::automatic));
  ASSERT_TRUE(solution.converged());
  EXPECT_LT(largest_deviation(solution.fluence, four_pi * 2.5), 1e-10);
  expect_closed_balances(problem, solution);
}

TEST(Conservation, ScatteringWithoutAbsorptionLosesNothing) {
  // The trap of a removal term without out-scattering: light that only scatters must all come out again.
  const TetrahedralMesh mesh = cube_mesh(3e-2);
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(name == "zmax"   ? uniform_wall(1, 1, 0, 0)
                    : name == "zmin" ? uniform_wall(1, 0, 0, 0)
                                     : uniform_wall(1, 0, 0, 1));
    walls.back().name = name;
  }
  Medium medium = uniform_medium(1, 0, 2, 0, PhaseHenyeyGreenstein{0.5});
  const Problem problem(mesh, Bands{}, {medium}, walls);
  const Solution solution = solve(problem, directions_triangular(4), tight_options());
  ASSERT_TRUE(solution.converged());
  const Balance balance = balances(problem, solution).front();
  EXPECT_EQ(balance.absorbed, 0);
  EXPECT_GT(balance.inflow, 1);
  EXPECT_LT(std::abs(balance.residual), 1e-10);
}

/// Turned about z, so that four of the cube's sides face between the axes.
Vec3 turned(const Vec3& p) {
  const double c = std::cos(0.3), s = std::sin(0.3);
  return {c * p.x() - s * p.y(), s * p.x() + c * p.y(), p.z()};
}

TEST(Walls, DiffuseReflectanceKeepsTheBalanceOnObliqueWalls) {
  const TetrahedralMesh mesh = moved_mesh(cube_mesh(2e-2), turned);
  const Problem problem = uniform_problem(mesh, uniform_medium(3, 0.1, 0.4, 1), uniform_wall(3, 0.3, 0.7, 0));
  const Solution solution = solve(problem, directions_product(4), tight_options());
  ASSERT_TRUE(solution.converged());
  expect_closed_balances(problem, solution);
}

TEST(Walls, BlackAndColdWithNothingInsideIsDarkAndConverged) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 0.5, 0.5, 0), uniform_wall(1, 0, 0.5, 0));
  const Solution solution = solve(problem, directions_triangular(2), tight_options());
  EXPECT_TRUE(solution.converged());
  for (const double value : solution.fluence) EXPECT_EQ(value, 0);
}

TEST(Walls, MirrorEqualsTheProblemWithItsImage) {
  const TetrahedralMesh mesh = cube_mesh(3e-2);
  const Medium medium = uniform_medium(1, 0.5, 0.5, 1);
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(name == "xmax" ? uniform_wall(1, 0, 0, 1) : uniform_wall(1, 0.3, 0.4, 0));
    walls.back().name = name;
  }
  const Problem folded(mesh, Bands{}, {medium}, walls);
  const Solution half = solve(folded, directions_ldfe_sq(1), tight_options());

  const TetrahedralMesh twice = mesh_with_image(mesh);
  const Problem with_image = uniform_problem(twice, medium, uniform_wall(1, 0.3, 0.4, 0));
  const Solution whole = solve(with_image, directions_ldfe_sq(1), tight_options());

  const CellLocator locator(mesh), locator_of_twice(twice);
  for (const Vec3& point : {Vec3(0.21, 0.33, 0.47), Vec3(0.83, 0.12, 0.71), Vec3(0.99, 0.5, 0.52)}) {
    const double expected = probe(with_image, whole, locator_of_twice, point)[0].fluence;
    EXPECT_NEAR(probe(folded, half, locator, point)[0].fluence, expected, 1e-10 * expected);
    const Vec3 image(2 - point.x(), point.y(), point.z());
    EXPECT_NEAR(probe(with_image, whole, locator_of_twice, image)[0].fluence, expected, 1e-10 * expected);
  }
}

TEST(Walls, MirrorOutsideTheSetIsRefusedWithTheReason) {
  const TetrahedralMesh oblique = moved_mesh(cube_mesh(2e-2), turned);
  Wall wall = uniform_wall(1, 0, 0, 0.5);
  wall.name = "boundary";
  wall.origin = {"room.toml", 12, "walls.boundary"};
  const Problem problem(oblique, Bands{}, {uniform_medium(1, 1, 0, 1)}, {wall});
  try {
    solve(problem, directions_triangular(4), SolveOptions{});
    FAIL() << "accepted";
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_EQ(text.find("room.toml:12: walls.boundary.specular: the mirror at ("), 0u) << text;
    EXPECT_NE(text.find("a mirrored ordinate must be in it"), std::string::npos) << text;
  }
}

TEST(LaggedFaces, ConvergeToTheSolutionOfTheRing) {
  // Upright ordinates go round the ring; what one sweep sends through the lagged faces the next one takes in.
  const TetrahedralMesh mesh = moved_mesh(cyclic_ring(), [](const Vec3& p) -> Vec3 {
    // Turned so that an ordinate of the set lies along the ring's axis.
    const Vec3 axis = directions_ldfe_sq(1).direction(OrdinateIndex(0));
    return rotation_about(Vec3::UnitZ() + axis, 180) * p;
  });
  const double level = 3;
  Wall wall = uniform_wall(1, 0.5 * level, 0.5, 0);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 0.2, 0.4, 0.2 * level), wall);
  const Solution solution = solve(problem, directions_ldfe_sq(1), tight_options());
  EXPECT_GT(solution.lagged_faces, 0);
  ASSERT_TRUE(solution.converged());
  EXPECT_LT(largest_deviation(solution.fluence, four_pi * level), 1e-10);
  expect_closed_balances(problem, solution);
  // A wall that only lights one side is carried round too, and the balance tells of any loss.
  const Problem lit = uniform_problem(mesh, uniform_medium(1, 0, 0, 0), uniform_wall(1, 1, 0, 0));
  const Solution through = solve(lit, directions_ldfe_sq(1), tight_options());
  ASSERT_TRUE(through.converged());
  EXPECT_LT(largest_deviation(through.fluence, four_pi), 1e-10);
}

TEST(Symmetry, OctahedralGroupOfTheMeshIsThatOfTheSolution) {
  // Turning mesh and nothing else: the set is closed under the group, so the fields turn with the mesh.
  const TetrahedralMesh mesh = cube_mesh(4e-2);
  const auto total = [&](const Eigen::Matrix3d& turn) {
    const TetrahedralMesh image = moved_mesh(mesh, [&](const Vec3& p) -> Vec3 { return turn * p; });
    Wall wall = uniform_wall(1, 0.2, 0.5, 0);
    wall.name = "boundary";
    Medium medium = uniform_medium(1, 0.5, 1, 0, PhaseHenyeyGreenstein{0.5});
    // Brighter near one corner, wherever that corner went.
    const Vec3 corner = turn * Vec3(0.2, 0.3, 0.4);
    std::string text = "exp(-((x-(" + std::to_string(corner.x()) + "))^2+(y-(" + std::to_string(corner.y()) +
                       "))^2+(z-(" + std::to_string(corner.z()) + "))^2))";
    medium.emission[0] = Coefficient(Expression(text, {"x", "y", "z"}));
    const Problem problem(image, Bands{}, {medium}, {wall});
    const Solution solution = solve(problem, directions_ldfe_sq(1), tight_options());
    double sum = 0, weighted = 0;
    for (std::int32_t c = 0; c < image.cell_count(); ++c)
      for (std::size_t i = 0; i < 4; ++i) {
        const Vec3 x = turn.transpose() * image.point(VertexIndex(image.vertices(CellIndex(c))[i]));
        const double value =
            solution.fluence[static_cast<std::size_t>(4 * c) + i] * image.volume(CellIndex(c));
        sum += value;
        weighted += value * (x.x() + 2 * x.y() * x.y() + 3 * x.z() * x.x());
      }
    return std::pair{sum, weighted};
  };
  const auto still = total(Eigen::Matrix3d::Identity());
  Eigen::Matrix3d turn;
  for (int axes = 0; axes < 6; ++axes)
    for (int signs = 0; signs < 8; signs += 5) {
      const int order[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
      turn.setZero();
      for (int row = 0; row < 3; ++row) turn(row, order[axes][row]) = (signs >> row) & 1 ? -1 : 1;
      const auto image = total(turn);
      EXPECT_NEAR(image.first, still.first, 1e-11 * still.first);
      EXPECT_NEAR(image.second, still.second, 1e-11 * std::abs(still.second));
    }
}

}  // namespace
}  // namespace etendue::enclosure_test
