// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Leaves, flakes and general kernels in whole solutions.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "tests/solver/transport/directional_media.h"

namespace etendue::directional_media_test {
namespace {

constexpr double leaf_density = 0.2;

Solution through_level_leaves(const TetrahedralMesh& mesh, const DirectionSet& directions) {
  const Problem problem(mesh, Bands{},
                        {medium_of(LeafCanopy{LeafAngles::horizontal, 0, 0}, leaf_density / 2, 0)},
                        column(mesh));
  SolveOptions options = tight_options();
  options.tolerance = 1e-9;
  for (int m = 0; m < directions.count(); m += 5) options.keep_ordinates.push_back(m);
  Solution solution = solve(problem, directions, options);
  EXPECT_TRUE(solution.converged());
  EXPECT_LT(std::abs(balances(problem, solution).front().residual), 1e-7);
  return solution;
}

// Extinction u_L |mu| along a path of H/|mu|: exp(-u_L H) whatever the direction.
TEST(LeafCanopy, OfBlackLevelLeavesLetsEveryOrdinateThroughAlike) {
  const DirectionSet directions = directions_ldfe_sq(1);
  std::vector<double> largest;
  for (const double volume : {8e-2, 1e-2}) {
    const TetrahedralMesh mesh = cube_mesh(volume);
    largest.push_back(0);
    for (const OrdinateRadiance& kept : through_level_leaves(mesh, directions).radiance) {
      const bool up = directions.direction(OrdinateIndex(kept.ordinate)).z() > 0;
      largest.back() =
          std::max(largest.back(), std::abs(mean_at_top(mesh, kept) - (up ? std::exp(-leaf_density) : 0)));
    }
  }
  // The error of the outflow is of third order in the size of the cells; half the size was asked for.
  EXPECT_LT(largest[1], 2e-5);
  EXPECT_LT(largest[1], largest[0] / 4);
}

TEST(LeafCanopy, OfBlackLevelLeavesIsAnAbsorberForEachOrdinate) {
  const TetrahedralMesh mesh = cube_mesh(3e-2);
  const DirectionSet directions = directions_ldfe_sq(1);
  const Solution leaves = through_level_leaves(mesh, directions);
  for (std::size_t i = 0; i < leaves.radiance.size(); i += 4) {
    const OrdinateRadiance& kept = leaves.radiance[i];
    const double slope = std::abs(directions.direction(OrdinateIndex(kept.ordinate)).z());
    const Problem absorber(mesh, Bands{}, {uniform_medium(1, leaf_density * slope, 0, 0, PhaseIsotropic{})},
                           column(mesh));
    SolveOptions options = tight_options();
    options.keep_ordinates = {kept.ordinate};
    const Solution plain = solve(absorber, directions, options);
    for (std::size_t k = 0; k < kept.values.size(); ++k)
      EXPECT_NEAR(kept.values[k], plain.radiance.front().values[k], 1e-8) << kept.ordinate;
  }
}

TEST(LeafCanopy, ThatDoesNotAbsorbLosesNothing) {
  const TetrahedralMesh mesh = cube_mesh(3e-2);
  for (const LeafAngles angles : {LeafAngles::horizontal, LeafAngles::erectophile}) {
    const Problem problem(mesh, Bands{}, {medium_of(LeafCanopy{angles, 0.6, 0.4}, 0, 1.5)}, column(mesh));
    const Solution solution = solve(problem, directions_ldfe_sq(1), tight_options());
    ASSERT_TRUE(solution.converged());
    EXPECT_LT(std::abs(balances(problem, solution).front().absorbed), 1e-12);
    expect_balance(problem, solution);
  }
}

TEST(DirectionalMedia, CloseTheBalanceWithWhatEveryDirectionAbsorbs) {
  const TetrahedralMesh mesh = cube_mesh(3e-2);
  const MicroFlakes flakes{Vec3(0.6, 0, 0.8), 0.3, 1, 0.7};
  for (const DirectionalScattering& law :
       {DirectionalScattering(LeafCanopy{LeafAngles::planophile, 0.3, 0.2}), DirectionalScattering(flakes)}) {
    const Problem problem(mesh, Bands{}, {medium_of(law, 0.6, 0.7)}, column(mesh));
    const Solution solution = solve(problem, directions_ldfe_sq(1), tight_options());
    ASSERT_TRUE(solution.converged());
    EXPECT_GT(balances(problem, solution).front().absorbed, 0.1);
    expect_balance(problem, solution);
  }
}

TEST(MicroFlakes, OfARoundShapeLetThroughWhatIsotropicScatteringDoes) {
  const TetrahedralMesh mesh = cube_mesh(6e-2);
  Medium isotropic = uniform_medium(1, 0, 2, 0, PhaseIsotropic{});
  isotropic.choice = {{ScatteringBackend::dense, -1, ForwardPeak::automatic}};
  SolveOptions options = tight_options();
  options.tolerance = 1e-14;
  const Solution a =
      solve(Problem(mesh, Bands{}, {medium_of(MicroFlakes{Vec3::UnitX(), 1, 1, 1}, 0, 2)}, column(mesh)),
            directions_ldfe_sq(1), options);
  const Solution b = solve(Problem(mesh, Bands{}, {isotropic}, column(mesh)), directions_ldfe_sq(1), options);
  for (std::size_t i = 0; i < a.fluence.size(); ++i)
    EXPECT_NEAR(a.fluence[i], b.fluence[i], 1e-10 * b.fluence[i]);
}

TEST(GeneralKernel, ThatIsHenyeyAndGreensteinsGivesItsAnswer) {
  const TetrahedralMesh mesh = cube_mesh(3e-2);
  const Problem general(
      mesh, Bands{},
      {medium_of(kernel("1.5/(4*pi)*(1-0.6^2)/(1+0.6^2-2*0.6*(wx*vx+wy*vy+wz*vz))^1.5"), 0.3, 1.5)},
      column(mesh));
  Medium known = uniform_medium(1, 0.3, 1.5, 0, PhaseHenyeyGreenstein{0.6});
  known.choice = {{ScatteringBackend::dense, -1, ForwardPeak::automatic}};
  const Problem expected(mesh, Bands{}, {known}, column(mesh));
  SolveOptions options = tight_options();
  options.tolerance = 1e-14;
  const Solution a = solve(general, directions_ldfe_sq(1), options);
  const Solution b = solve(expected, directions_ldfe_sq(1), options);
  for (std::size_t i = 0; i < a.fluence.size(); ++i)
    EXPECT_NEAR(a.fluence[i], b.fluence[i], 1e-12 * b.fluence[i]);
  EXPECT_NEAR(a.kernels[0].asymmetry, 0.6, 1e-10);
}

/// The cells of a mesh in two regions, below and above z = 0.5 by their centroids.
TetrahedralMesh in_two_regions(const TetrahedralMesh& mesh) {
  RawMesh raw;
  raw.points.assign(mesh.points().begin(), mesh.points().end());
  raw.region_names = {"below", "above"};
  for (const auto& cell : mesh.cell_vertices()) {
    const auto point = [&](std::size_t i) { return mesh.point(VertexIndex(cell[i])); };
    const double turn = (point(1) - point(0)).cross(point(2) - point(0)).dot(point(3) - point(0));
    raw.cells.push_back({cell[0], cell[1], cell[turn > 0 ? 2 : 3], cell[turn > 0 ? 3 : 2]});
    double height = 0;
    for (const std::int32_t v : cell) height += mesh.point(VertexIndex(v)).z() / 4;
    raw.cell_regions.push_back(height < 0.5 ? 0 : 1);
  }
  return TetrahedralMesh(raw);
}

const std::string first_kernel = "(1-0.3^2)/(4*pi)/(1+0.3^2-2*0.3*(wx*vx+wy*vy+wz*vz))^1.5";
const std::string second_kernel = "(2+wx*vy)/(4*pi)";

TEST(KernelByCell, OfTwoKindsGivesTheAnswerOfTwoRegions) {
  const TetrahedralMesh one = moved_mesh(cube_mesh(6e-2), [](const Vec3& point) { return point; });
  const TetrahedralMesh two = in_two_regions(one);
  Medium below = medium_of(kernel(first_kernel), 0.3, 1), above = medium_of(kernel(second_kernel), 0.3, 2);
  below.name = "below";
  above.name = "above";
  Wall wall = uniform_wall(1, 1, 0, 0);
  wall.name = two.wall_names().front();
  const Problem expected(two, Bands{}, {below, above}, {wall});
  wall.name = one.wall_names().front();
  const Problem problem(
      one, Bands{}, {medium_of(kernel("z < 0.5 ? " + first_kernel + " : " + second_kernel), 0.3, 1)}, {wall});
  EXPECT_EQ(kernel_places(problem, 0, 0).size(), 2u);
  SolveOptions options = tight_options();
  options.tolerance = 1e-13;
  const Solution a = solve(problem, directions_product(4), options);
  const Solution b = solve(expected, directions_product(4), options);
  ASSERT_TRUE(a.converged());
  for (std::size_t i = 0; i < a.fluence.size(); ++i)
    EXPECT_NEAR(a.fluence[i], b.fluence[i], 1e-11 * b.fluence[i]);
}

TEST(KernelByCell, WhoseAsymmetryDependsOnThePlaceLosesNothing) {
  const TetrahedralMesh mesh = cube_mesh(6e-2);
  const Problem problem(mesh, Bands{}, {medium_of(kernel("2/(4*pi)*(1+0.9*z*(wx*vx+wy*vy+wz*vz))"), 0, 2)},
                        column(mesh));
  const DirectionSet directions = directions_product(4);
  const Solution solution = solve(problem, directions, tight_options());
  ASSERT_TRUE(solution.converged());
  expect_balance(problem, solution);
  EXPECT_LT(solution.kernels[0].energy_error, 1e-9);
  EXPECT_LT(solution.kernels[0].momentum_error, 1e-9);
  EXPECT_NEAR(solution.kernels[0].asymmetry, 0.3 * 0.5, 0.02);
  // Every height has its matrix, which the log says and the estimate of memory counts.
  const auto places = static_cast<double>(kernel_places(problem, 0, 0).size());
  EXPECT_GT(places, 50);
  EXPECT_NE(solution.kernels[0].backend.find("MiB for the matrices of "), std::string::npos);
  const Problem alike(mesh, Bands{}, {medium_of(kernel(first_kernel), 0, 1)}, column(mesh));
  const double matrix = 16.0 * directions.count() * directions.count();
  SolveOptions full;
  full.precision = Precision::full;
  EXPECT_NEAR(static_cast<double>(estimate_memory(problem, directions, full)) -
                  static_cast<double>(estimate_memory(alike, directions, full)),
              (places - 1) * matrix, 8);
}

TEST(KernelByCell, IsOneMatrixForAProduct) {
  const TetrahedralMesh mesh = cube_mesh(6e-2);
  const auto places = [&](const std::string& text) {
    return kernel_places(std::get<KernelFormula>(kernel(text)), mesh, 0);
  };
  EXPECT_TRUE(places(first_kernel).empty());
  EXPECT_TRUE(places("(1+x*z)*" + first_kernel).empty());
  std::size_t cells = 0;
  for (const KernelPlace& place : places("1+x*wz*vz")) cells += place.cells.size();
  EXPECT_EQ(cells, static_cast<std::size_t>(mesh.cell_count()));
}

TEST(KernelByCell, ThatIsNegativeNamesItsMediumAndThePlace) {
  const TetrahedralMesh mesh = cube_mesh(6e-2);
  const Problem problem(mesh, Bands{}, {medium_of(kernel("1 + 2*z*wx*vx"), 0, 1)}, column(mesh));
  try {
    solve(problem, directions_product(4), tight_options());
    FAIL();
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("media.domain"), std::string::npos) << text;
    EXPECT_NE(text.find("at ("), std::string::npos) << text;
    EXPECT_NE(text.find("the kernel is -"), std::string::npos) << text;
  }
}

TEST(GeneralKernel, GivenAsTheMatrixOfHenyeyAndGreensteinGivesItsAnswer) {
  const TetrahedralMesh mesh = cube_mesh(3e-2);
  const DirectionSet directions = directions_ldfe_sq(1);
  const DenseKernel known = dense_kernel(PhaseHenyeyGreenstein{0.6}, directions);
  KernelMatrix matrix;
  matrix.count = directions.count();
  // [from][into], while the rates are [into][from].
  matrix.values.assign(known.rate.data(), known.rate.data() + known.rate.size());
  for (double& value : matrix.values) value *= 1.5;
  double leaving = 0;
  for (int m = 0; m < directions.count(); ++m)
    leaving += 1.5 * known.leaving[static_cast<std::size_t>(m)] * directions.weight(OrdinateIndex(m)) /
               (4 * std::numbers::pi);
  Medium phase = uniform_medium(1, 0.3, 1.5, 0, PhaseHenyeyGreenstein{0.6});
  phase.choice = {{ScatteringBackend::dense, -1, ForwardPeak::automatic}};
  SolveOptions options = tight_options();
  options.tolerance = 1e-14;
  const Solution a =
      solve(Problem(mesh, Bands{}, {medium_of(matrix, 0.3, leaving)}, column(mesh)), directions, options);
  const Solution b = solve(Problem(mesh, Bands{}, {phase}, column(mesh)), directions, options);
  for (std::size_t i = 0; i < a.fluence.size(); ++i)
    EXPECT_NEAR(a.fluence[i], b.fluence[i], 1e-12 * b.fluence[i]);
}

TEST(GeneralKernel, ThatBreaksEnergyNamesItsMediumAndADirection) {
  const TetrahedralMesh mesh = cube_mesh(0.1);
  KernelFormula formula;
  formula.formula = std::make_shared<Expression>("0.1*(1 + wz*vz)", kernel_variables());
  formula.extinction = 1;
  Medium medium = medium_of(formula, 0.1, 1.2566);
  medium.name = "fog";
  medium.origin = {"room.toml", 7, "media.fog"};
  try {
    solve(Problem(mesh, Bands{}, {medium}, column(mesh)), directions_ldfe_sq(1), SolveOptions{});
    FAIL() << "accepted";
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_EQ(text.rfind("room.toml:7: media.fog: the kernel scatters 1.25664 of each unit of length out of "
                         "the direction (",
                         0),
              0u)
        << text;
  }
}

TEST(GeneralKernel, ThatBreaksItsClaimOfReciprocityNamesItsMediumAndTheDirections) {
  const TetrahedralMesh mesh = cube_mesh(0.1);
  KernelFormula formula;
  formula.formula = std::make_shared<Expression>("0.1*(1 + 0.5*vz)", kernel_variables());
  formula.reciprocal = true;
  Medium medium = medium_of(formula, 0.1, 1.2566);
  medium.origin = {"room.toml", 7, "media.fog"};
  try {
    solve(Problem(mesh, Bands{}, {medium}, column(mesh)), directions_ldfe_sq(1), SolveOptions{});
    FAIL() << "accepted";
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_EQ(text.rfind("room.toml:7: media.fog: ", 0), 0u) << text;
    EXPECT_NE(text.find("from ("), std::string::npos) << text;
    EXPECT_NE(text.find(" into ("), std::string::npos) << text;
  }
}

TEST(GeneralKernel, ThatIsRefusedNamesItsMedium) {
  const TetrahedralMesh mesh = cube_mesh(0.1);
  Medium medium = medium_of(kernel("vz"), 0.3, 1.5);
  medium.name = "fog";
  medium.origin = {"room.toml", 7, "media.fog"};
  const Problem problem(mesh, Bands{}, {medium}, column(mesh));
  try {
    solve(problem, directions_ldfe_sq(1), SolveOptions{});
    FAIL() << "accepted";
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_EQ(text.rfind("room.toml:7: media.fog: the kernel is -", 0), 0u) << text;
  }
}

}  // namespace
}  // namespace etendue::directional_media_test
