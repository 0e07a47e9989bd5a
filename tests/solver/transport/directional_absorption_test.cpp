// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Absorption that depends on the direction, in whole solutions.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "tests/solver/transport/directional_media.h"

namespace etendue::directional_absorption_test {
namespace {

Medium absorber_by(const std::string& absorption, double mean, double scattering,
                   PhaseFunction phase = PhaseHenyeyGreenstein{0.6}) {
  Medium medium = uniform_medium(1, mean, scattering, 0, std::move(phase));
  medium.absorption_by_direction = {AngularFormula(absorption)};
  return medium;
}

TEST(DirectionalAbsorption, ByTheSlopeOfARayIsThatOfBlackLevelLeaves) {
  const TetrahedralMesh mesh = cube_mesh(6e-2);
  const DirectionSet directions = directions_ldfe_sq(1);
  const Problem leaves(mesh, Bands{}, {medium_of(LeafCanopy{LeafAngles::horizontal, 0, 0}, 0.4, 0)},
                       column(mesh));
  const Problem formula(mesh, Bands{}, {absorber_by("0.8*abs(wz)", 0.4, 0)}, column(mesh));
  const Solution a = solve(leaves, directions, tight_options());
  const Solution b = solve(formula, directions, tight_options());
  ASSERT_EQ(a.fluence.size(), 4 * static_cast<std::size_t>(mesh.cell_count()));
  ASSERT_EQ(b.fluence.size(), a.fluence.size());
  for (std::size_t i = 0; i < a.fluence.size(); ++i) EXPECT_NEAR(a.fluence[i], b.fluence[i], 1e-10);
  expect_balance(formula, b);
}

// Extinction (1 + z) |mu| along a path dz/|mu|: exp(-3/2) whatever the direction.
TEST(DirectionalAbsorption, OfPlaceAndDirectionTransmitsEveryOrdinateAsItsIntegralSays) {
  const TetrahedralMesh mesh = cube_mesh(1e-2);
  const DirectionSet directions = directions_ldfe_sq(1);
  const Problem problem(mesh, Bands{}, {absorber_by("(1 + z)*abs(wz)", 0.75, 0)}, column(mesh));
  SolveOptions options = tight_options();
  for (int m = 0; m < directions.count(); m += 11) options.keep_ordinates.push_back(m);
  const Solution solution = solve(problem, directions, options);
  ASSERT_EQ(solution.radiance.size(), options.keep_ordinates.size());
  for (const OrdinateRadiance& kept : solution.radiance) {
    const bool up = directions.direction(OrdinateIndex(kept.ordinate)).z() > 0;
    EXPECT_NEAR(mean_at_top(mesh, kept), up ? std::exp(-1.5) : 0, 2e-3) << kept.ordinate;
  }
  expect_balance(problem, solution);
}

TEST(DirectionalAbsorption, ThatDoesNotVaryIsPlainAbsorption) {
  const TetrahedralMesh mesh = cube_mesh(6e-2);
  Medium plain = uniform_medium(1, 0.3, 1.2, 0, PhaseHenyeyGreenstein{0.6});
  plain.choice = {{ScatteringBackend::dense, -1, ForwardPeak::automatic}};
  const Solution a =
      solve(Problem(mesh, Bands{}, {plain}, column(mesh)), directions_ldfe_sq(1), tight_options());
  const Problem problem(mesh, Bands{}, {absorber_by("0.3 + 0*wx", 0.3, 1.2)}, column(mesh));
  const Solution b = solve(problem, directions_ldfe_sq(1), tight_options());
  ASSERT_EQ(a.fluence.size(), 4 * static_cast<std::size_t>(mesh.cell_count()));
  ASSERT_EQ(b.fluence.size(), a.fluence.size());
  for (std::size_t i = 0; i < a.fluence.size(); ++i) EXPECT_NEAR(a.fluence[i], b.fluence[i], 1e-10);
}

TEST(DirectionalAbsorption, ClosesTheBalanceWithScattering) {
  const TetrahedralMesh mesh = cube_mesh(6e-2);
  const Problem problem(mesh, Bands{}, {absorber_by("0.4*(1 + wx)*(1 + y)", 0.6, 1.5)}, column(mesh));
  const Solution solution = solve(problem, directions_ldfe_sq(1), tight_options());
  ASSERT_TRUE(solution.converged());
  EXPECT_GT(balances(problem, solution).front().absorbed, 0.1);
  expect_balance(problem, solution);
}

TEST(DirectionalAbsorption, MayFollowFromTheExtinctionBesideAKernel) {
  const TetrahedralMesh mesh = cube_mesh(6e-2);
  Medium medium = medium_of(kernel("0.1"), 0.6, 0.4 * 3.14159265358979);
  Medium plain = medium;
  medium.extinction_by_direction = true;
  medium.absorption_by_direction = {AngularFormula("0.6 + 0.4*pi + 0.2*wz")};
  plain.absorption_by_direction = {AngularFormula("0.6 + 0.2*wz")};
  const Solution a =
      solve(Problem(mesh, Bands{}, {medium}, column(mesh)), directions_ldfe_sq(1), tight_options());
  const Solution b =
      solve(Problem(mesh, Bands{}, {plain}, column(mesh)), directions_ldfe_sq(1), tight_options());
  ASSERT_EQ(a.fluence.size(), 4 * static_cast<std::size_t>(mesh.cell_count()));
  ASSERT_EQ(b.fluence.size(), a.fluence.size());
  for (std::size_t i = 0; i < a.fluence.size(); ++i) EXPECT_NEAR(a.fluence[i], b.fluence[i], 1e-10);

  medium.absorption_by_direction = {AngularFormula("1.2 + 0.2*wz")};
  const Problem too_little(mesh, Bands{}, {medium}, column(mesh));
  try {
    solve(too_little, directions_ldfe_sq(1), SolveOptions{});
    FAIL() << "accepted";
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("media.domain.extinction = 1."), std::string::npos) << text;
    EXPECT_NE(text.find("less than the 1.25664 that the kernel scatters"), std::string::npos) << text;
    EXPECT_NE(text.find("in the direction ("), std::string::npos) << text;
  }
}

TEST(DirectionalAbsorption, ThatIsNegativeNamesTheMediumAndTheDirection) {
  const TetrahedralMesh mesh = cube_mesh(0.1);
  const Problem problem(mesh, Bands{}, {absorber_by("0.1 + wy", 0.1, 0)}, column(mesh));
  try {
    solve(problem, directions_ldfe_sq(1), SolveOptions{});
    FAIL() << "accepted";
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("media.domain.absorption = -0."), std::string::npos) << text;
    EXPECT_NE(text.find("in the direction ("), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace etendue::directional_absorption_test
