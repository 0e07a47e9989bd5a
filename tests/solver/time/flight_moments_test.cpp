// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/time/flight_moments.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "solver/time/solve_laplace.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::flight_moments_test {
namespace {

using Fluences = std::vector<std::vector<double>>;  // [k][cell][4][band]

Fluences moments_of(const Problem& problem, const DirectionSet& directions, const Slowness& slowness,
                    const SolveOptions& options) {
  Fluences moments;
  solve_flight_moments(problem, directions, slowness, 2, options,
                       [&](int k, const Problem&, const Solution& moment, const UncollidedValues*) {
                         EXPECT_TRUE(moment.converged());
                         EXPECT_EQ(static_cast<std::size_t>(k), moments.size());
                         moments.push_back(moment.fluence);
                       });
  return moments;
}

/// Between mirrors light decays as e^(-sigma_a c t/n): mean and deviation are n/(c sigma_a).
TEST(FlightMoments, AreThoseOfAnExponentialBetweenMirrors) {
  const TetrahedralMesh mesh = cube_mesh(8e-2);
  const Problem problem = uniform_problem(mesh, uniform_medium(2, 0.5, 1.5, 0.25), uniform_wall(2, 0, 0, 1));
  const Fluences moments = moments_of(problem, directions_product(2), {1.4}, tight_options());
  ASSERT_EQ(moments.size(), 3U);
  const double lag = 1.4 / 0.5, steady = 4 * std::numbers::pi * 0.25 / 0.5;
  ASSERT_FALSE(moments[0].empty());
  for (std::size_t i = 0; i < moments[0].size(); ++i) {
    EXPECT_NEAR(moments[0][i], steady, 1e-8 * steady);
    EXPECT_NEAR(moments[1][i], steady * lag, 1e-8 * steady * lag);
    EXPECT_NEAR(moments[2][i], 2 * steady * lag * lag, 1e-8 * steady * lag * lag);
  }
}

/// Derivatives of the transform at s = 0 by a difference there: F(i e) = M_0 - i e M_1 - e^2 M_2 / 2 + ...
void expect_derivatives_of_the_transform(const Problem& problem, const Slowness& slowness,
                                         const DirectionSet& directions) {
  SolveOptions options = tight_options(Lumping::automatic);
  options.tolerance = 1e-12;
  const Fluences moments = moments_of(problem, directions, slowness, options);
  ASSERT_EQ(moments.size(), 3U);
  constexpr double e = 0.02;
  const std::vector<std::complex<double>> rates = {{0, e}, {0, 2 * e}};
  solve_laplace(problem, {directions}, rates, slowness, options, [&](const SolvedRates& solved) {
    EXPECT_EQ(solved.count, 2U);
    const auto bands = static_cast<std::size_t>(problem.band_count());
    const std::vector<double>& f = solved.solution.fluence;
    double largest[3] = {};
    for (std::size_t k = 0; k < 3; ++k)
      for (const double value : moments[k]) largest[k] = std::max(largest[k], std::abs(value));
    for (std::size_t i = 0; i < moments[0].size(); ++i) {
      const std::size_t node = i / bands, band = i % bands;
      const auto part = [&](std::size_t rate, std::size_t p) {
        return f[(node * 2 * bands + rate * bands + band) * 2 + p];
      };
      // Of fourth order in e, by both rates.
      const double first = -(8 * part(0, 1) - part(1, 1)) / (6 * e);
      const double second = -(16 * (part(0, 0) - moments[0][i]) - (part(1, 0) - moments[0][i])) / (6 * e * e);
      EXPECT_NEAR(moments[1][i], first, 1e-5 * largest[1]);
      EXPECT_NEAR(moments[2][i], second, 1e-4 * largest[2]);
    }
    return true;
  });
}

TEST(FlightMoments, AreDerivativesOfTheTransform) {
  const TetrahedralMesh mesh = cube_with_ball(8e-2);
  Medium medium = uniform_medium(2, 0.3, 2, 0.7, PhaseHenyeyGreenstein{0.5});
  medium.scattering[1] = Coefficient(6.0);
  expect_derivatives_of_the_transform(uniform_problem(mesh, medium, uniform_wall(2, 0.9, 0.3, 0.2)), {1, 1.5},
                                      directions_product(4));
}

TEST(FlightMoments, AreDerivativesWithALamp) {
  const TetrahedralMesh mesh = cube_mesh(8e-2);
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(uniform_wall(1, 0.4, 0.3, 0));
    walls.back().name = name;
  }
  Medium medium = uniform_medium(1, 0.2, 1, 0);
  medium.name = mesh.region_names().front();
  PointLight lamp;
  lamp.position = Vec3(0.4, 0.3, 0.6);
  lamp.power = {5};
  expect_derivatives_of_the_transform(Problem(mesh, {{"a"}, {}}, {medium}, walls, AngularSpace::sphere,
                                              {{"lamp", lamp, {}, Uncollided::automatic}}),
                                      {1.2}, directions_product(4));
}

}  // namespace
}  // namespace etendue::flight_moments_test
