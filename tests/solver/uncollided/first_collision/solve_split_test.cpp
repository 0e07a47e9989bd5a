// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/first_collision/solve_split.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "base/errors.h"
#include "solver/solution/balance.h"
#include "solver/uncollided/first_collision/first_collision.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::solve_split_test {
namespace {

Light lamp(const Vec3& position) {
  PointLight point;
  point.position = position;
  point.power = {1};
  return {"lamp", point, {}};
}

Problem with_lamp(const TetrahedralMesh& mesh, const Medium& medium, const Wall& wall) {
  std::vector<Medium> media(mesh.region_names().size(), medium);
  std::vector<Wall> walls(mesh.wall_names().size(), wall);
  for (std::size_t i = 0; i < walls.size(); ++i) walls[i].name = mesh.wall_names()[i];
  return Problem(mesh, {}, media, walls, AngularSpace::sphere, {lamp({0.4, 0.55, 0.6})});
}

double mean_fluence(const TetrahedralMesh& mesh, const Solution& solution) {
  double sum = 0;
  for (std::size_t i = 0; i < solution.fluence.size(); ++i)
    sum += solution.fluence[i] * mesh.volumes()[i / 4] / 4;
  return sum;
}

TEST(SolveSplit, BalancesWithScatteringAndReflectingWalls) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  for (const PhaseFunction& phase :
       {PhaseFunction(PhaseIsotropic{}), PhaseFunction(PhaseHenyeyGreenstein{0.7})}) {
    const Problem problem = with_lamp(mesh, uniform_medium(1, 0.3, 2, 0, phase), uniform_wall(1, 0, 0.5, 0));
    const LightSetup lights(problem);
    const Solution solution = solve_split(lights, directions_ldfe_sq(1), tight_options());
    EXPECT_TRUE(solution.converged());
    EXPECT_NEAR(solution.lights.balance[0].sent, 1, 1e-12);
    // These cells are a third of the room wide; what the rules miss of the light is all that is missed.
    EXPECT_NEAR(solution.lights.balance[0].residual, 0, 1e-4);
    EXPECT_NEAR(balances(problem, solution)[0].residual, solution.lights.balance[0].residual, 1e-9);
    EXPECT_NEAR(balances(problem, solution)[0].inflow, 1, 1e-12);
  }
}

// On a wall, in an edge and in a corner, on a mirror too.
TEST(SolveSplit, BalancesWithLampsOnWalls) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  for (const Vec3& position : {Vec3(0.4, 0.55, 1), Vec3(0.4, 1, 1), Vec3(1, 1, 1), Vec3(0.3, 0.3, 0)}) {
    std::vector<Wall> walls;
    for (const std::string& name : mesh.wall_names()) {
      walls.push_back(uniform_wall(1, 0, 0.3, name == "zmin" ? 0.6 : 0));
      walls.back().name = name;
    }
    const Problem problem(mesh, {}, {uniform_medium(1, 0.3, 2, 0, PhaseHenyeyGreenstein{0.5})}, walls,
                          AngularSpace::sphere, {lamp(position)});
    const LightSetup lights(problem);
    const Solution solution = solve_split(lights, directions_ldfe_sq(1), tight_options());
    EXPECT_NEAR(balances(problem, solution)[0].residual, 0, 2e-4) << position.transpose();
  }
}

TEST(SolveSplit, KeepsThePowerOfTheFirstCollisions) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  const Problem problem =
      with_lamp(mesh, uniform_medium(1, 0.3, 2, 0, PhaseHenyeyGreenstein{0.9}), uniform_wall(1, 0, 0, 0));
  const LightSetup lights(problem);
  const UncollidedField field = uncollided_field(lights.paths(), lights.sources(), 1);
  const DirectionSet directions = directions_ldfe_sq(1);
  const FirstCollision source(lights, field, directions, 1);
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    std::vector<double> sum(4, 0);
    for (std::int32_t m = 0; m < directions.count(); ++m) {
      std::vector<double> values(4, 0);
      source.add_projected_source(OrdinateIndex(m), CellIndex(c), values);
      for (std::size_t i = 0; i < 4; ++i) sum[i] += directions.weight(OrdinateIndex(m)) * values[i];
    }
    for (std::size_t i = 0; i < 4; ++i) {
      const double expected = 2 * field.fluence[static_cast<std::size_t>(c) * 4 + i];
      EXPECT_NEAR(sum[i], expected, 1e-12 * std::abs(expected));
    }
  }
}

Medium leaves() {
  Medium medium = uniform_medium(1, 0.35, 0.65, 0);
  medium.directional = {LeafCanopy{LeafAngles::planophile, 0.4, 0.25}};
  return medium;
}

TEST(SolveSplit, BalancesBesideLeaves) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  const Problem problem = with_lamp(mesh, leaves(), uniform_wall(1, 0, 0.5, 0));
  const LightSetup lights(problem);
  const Solution solution = solve_split(lights, directions_ldfe_sq(1), tight_options());
  EXPECT_TRUE(solution.converged());
  EXPECT_NEAR(solution.lights.balance[0].residual, 0, 1e-4);
  EXPECT_NEAR(balances(problem, solution)[0].residual, solution.lights.balance[0].residual, 1e-9);
}

TEST(SolveSplit, KeepsThePowerOfWhatLeavesScatter) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  const Problem problem = with_lamp(mesh, leaves(), uniform_wall(1, 0, 0, 0));
  const LightSetup lights(problem);
  const UncollidedField field = uncollided_field(lights.paths(), lights.sources(), 1);
  const DirectionSet directions = directions_ldfe_sq(1);
  const FirstCollision source(lights, field, directions, 2);
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    EXPECT_TRUE(source.depends_on_direction(CellIndex(c)));
    std::vector<double> sum(4, 0);
    for (std::int32_t m = 0; m < directions.count(); ++m) {
      std::vector<double> values(4, 0);
      source.add_projected_source(OrdinateIndex(m), CellIndex(c), values);
      for (std::size_t i = 0; i < 4; ++i) sum[i] += directions.weight(OrdinateIndex(m)) * values[i];
    }
    for (std::size_t i = 0; i < 4; ++i) {
      const double expected = field.collided[static_cast<std::size_t>(c) * 4 + i];
      EXPECT_NEAR(sum[i], expected, 1e-12 * std::abs(expected));
    }
  }
}

// Round flakes are isotropic scattering, and so are kernels that say so.
TEST(SolveSplit, FindsTheSameForAllWaysToSayIsotropic) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  Medium ordinary = uniform_medium(1, 0.4, 0.6, 0), round = ordinary, kernel = ordinary;
  ordinary.choice = {{ScatteringBackend::dense}};
  round.directional = {MicroFlakes{Vec3::UnitZ(), 1, 1, 0.6}};
  KernelFormula formula;
  formula.formula = std::make_shared<Expression>("0.6/(4*pi)", kernel_variables());
  kernel.directional = {formula};
  const auto fluence = [&](const Medium& medium) {
    const Problem problem = with_lamp(mesh, medium, uniform_wall(1, 0, 0.2, 0));
    const LightSetup lights(problem);
    return solve_split(lights, directions_ldfe_sq(1), tight_options()).fluence;
  };
  const std::vector<double> expected = fluence(ordinary);
  for (const std::vector<double>& found : {fluence(round), fluence(kernel)})
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-8);
}

// In a box of mirrors all light is absorbed at last.
TEST(SolveSplit, FindsTheFluenceOfAClosedBox) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  const Problem problem = with_lamp(mesh, uniform_medium(1, 0.5, 3, 0), uniform_wall(1, 0, 1, 0));
  const LightSetup lights(problem);
  const Solution solution = solve_split(lights, directions_ldfe_sq(1), tight_options());
  EXPECT_NEAR(0.5 * mean_fluence(mesh, solution), 1 - solution.lights.balance[0].residual, 1e-8);
}

// Cells of a quarter of the room and 96 directions leave errors of a percent in the sweep's own answer.
TEST(SolveSplit, AgreesWithTheSweepWhereThatIsGood) {
  const TetrahedralMesh mesh = two_region_mesh(0.02);
  std::vector<Medium> media(2, uniform_medium(1, 1, 3, 0, PhaseHenyeyGreenstein{0.5}));
  std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(1, 0, 0.3, 0));
  for (std::size_t i = 0; i < media.size(); ++i)
    if (mesh.region_names()[i] == "inner") media[i].emission = {Coefficient(1.0)};
  const auto solved = [&](Uncollided uncollided) {
    std::vector<Medium> own = media;
    for (Medium& medium : own) medium.uncollided = uncollided;
    const Problem problem(mesh, {}, own, walls);
    return solve_split(LightSetup(problem), directions_ldfe_sq(1), tight_options());
  };
  const Solution split = solved(Uncollided::yes), swept = solved(Uncollided::no);
  EXPECT_TRUE(swept.lights.fluence.empty());
  EXPECT_FALSE(split.lights.fluence.empty());
  EXPECT_NEAR(mean_fluence(mesh, split) / mean_fluence(mesh, swept), 1, 0.02);
}

// The one along rays, the other by the directions, or both by them: the same light.
TEST(SolveSplit, SweepsTheLightsThatSayNo) {
  const TetrahedralMesh mesh = cube_mesh(0.01);
  const Medium haze = uniform_medium(1, 1, 3, 0, PhaseHenyeyGreenstein{0.5});
  std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(1, 0, 0.3, 0));
  for (std::size_t i = 0; i < walls.size(); ++i) walls[i].name = mesh.wall_names()[i];
  std::vector<double> means;
  for (const bool both : {false, true}) {
    std::vector<Light> lamps = {lamp({0.4, 0.55, 0.6}), lamp({0.6, 0.3, 0.45})};
    lamps[1].name = "other";
    lamps[1].uncollided = Uncollided::no;
    if (both) lamps[0].uncollided = Uncollided::no;
    const Problem problem(mesh, {}, {haze}, walls, AngularSpace::sphere, lamps);
    const LightSetup lights(problem);
    EXPECT_EQ(lights.sources().size(), both ? 0U : 1U);
    const Solution solution = solve_split(lights, directions_ldfe_sq(1), tight_options());
    ASSERT_TRUE(solution.converged());
    EXPECT_NE(std::ranges::find(solution.notes, "light other: left to the directions (uncollided = false)"),
              solution.notes.end());
    const Balance balance = balances(problem, solution)[0];
    EXPECT_NEAR(balance.inflow, 2, 1e-12);
    EXPECT_NEAR(balance.residual, both ? 0 : solution.lights.balance[0].residual / 2, 1e-9);
    means.push_back(mean_fluence(mesh, solution));
  }
  EXPECT_NEAR(means[0] / means[1], 1, 0.02);
}

// Light that enters by a surface and cannot come back to it may be followed.
TEST(LightSetup, RefusesLightThatMeetsASurfaceFromWithin) {
  const TetrahedralMesh mesh = cube_mesh(0.05);
  std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(1, 0, 0, 0));
  int top = 0;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    walls[i].name = mesh.wall_names()[i];
    if (walls[i].name == "zmax") top = static_cast<int>(i);
  }
  walls[static_cast<std::size_t>(top)].refractive_index = 1.33;
  const auto accepted = [&](const Light& light, double mirror_below) {
    std::vector<Wall> own = walls;
    for (Wall& wall : own)
      if (wall.name == "zmin") wall.specular = {mirror_below};
    const Problem problem(mesh, {}, {uniform_medium(1, 1, 0, 0)}, own, AngularSpace::sphere, {light});
    try {
      return LightSetup(problem).sources().size() == 1;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("meets the wall zmax, which refracts, from within"),
                std::string::npos);
      return false;
    }
  };
  const Light down{"sun", BeamLight{-Vec3::UnitZ(), {1}, {top}}, {}};
  EXPECT_TRUE(accepted(down, 0));
  EXPECT_FALSE(accepted(down, 0.5));
  EXPECT_FALSE(accepted(lamp({0.4, 0.5, 0.5}), 0));
}

// A collimated beam through a cube of side 1 leaves exp(-extinction) of its power at the far side: below 1e-6
// it may refract there, and the light that is left out is in the balance as kept by the wall.
TEST(LightSetup, EndsATrifleOfLightAtASurface) {
  const TetrahedralMesh mesh = cube_mesh(0.05);
  std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(1, 0, 0, 0));
  int top = 0, bottom = 0;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    walls[i].name = mesh.wall_names()[i];
    if (walls[i].name == "zmax") top = static_cast<int>(i);
    if (walls[i].name == "zmin") bottom = static_cast<int>(i);
  }
  for (const int wall : {top, bottom}) walls[static_cast<std::size_t>(wall)].refractive_index = 1.33;
  const Light down{"sun", BeamLight{-Vec3::UnitZ(), {1}, {top}}, {}};
  const auto problem = [&](double extinction) {
    return Problem(mesh, {}, {uniform_medium(1, extinction, 0, 0)}, walls, AngularSpace::sphere, {down});
  };
  const Problem thin = problem(13), thick = problem(15);
  EXPECT_THROW(LightSetup{thin}, InputError);
  const LightSetup lights(thick);
  ASSERT_EQ(lights.notes().size(), 2u);
  EXPECT_EQ(lights.notes()[1].find("light sun: 3.1e-07 of its power reaches the wall zmin, which refracts"),
            0u)
      << lights.notes()[1];
  const Solution solution = solve_split(lights, directions_ldfe_sq(1), tight_options());
  EXPECT_NEAR(solution.lights.balance[0].kept, std::exp(-15.0), 1e-3 * std::exp(-15.0));
}

TEST(LightSetup, TakesSmallEmittersAndLeavesLargeOnes) {
  const TetrahedralMesh mesh = two_region_mesh(0.02);
  std::vector<Medium> media(2, uniform_medium(1, 1, 0, 1));
  std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(1, 0, 0, 0));
  const Problem large(mesh, {}, media, walls);
  EXPECT_TRUE(LightSetup(large).empty());
  for (Medium& medium : media) medium.uncollided = Uncollided::yes;
  const Problem asked(mesh, {}, media, walls);
  EXPECT_EQ(LightSetup(asked).sources().size(), 2U);
}

TEST(LightSetup, RefusesALampBetweenMirrorsThatFaceEachOther) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  const Problem problem = with_lamp(mesh, uniform_medium(1, 1, 0, 0), uniform_wall(1, 0, 0, 0.5));
  EXPECT_THROW(LightSetup{problem}, InputError);
}

}  // namespace
}  // namespace etendue::solve_split_test
