// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/time/laplace_problem.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "tests/solver/transport/sample_problems.h"

namespace etendue::laplace_problem_test {
namespace {

using Complex = std::complex<double>;

/// The complex fluence [cell][4][rate][band].
std::vector<Complex> complex_fluence(const Problem& problem, std::span<const Complex> rates,
                                     const Slowness& slowness, const DirectionSet& directions,
                                     SolveOptions options) {
  const LaplaceProblem laplace = laplace_problem(problem, rates, slowness);
  options.added_extinction = &laplace.extinction;
  const Solution solution = solve(laplace.problem, directions, options);
  EXPECT_TRUE(solution.converged());
  std::vector<Complex> result;
  for (std::size_t i = 0; i < solution.fluence.size(); i += 2)
    result.emplace_back(solution.fluence[i], solution.fluence[i + 1]);
  return result;
}

std::vector<Complex> complex_fluence(const Problem& problem, Complex rate, const Slowness& slowness,
                                     const DirectionSet& directions, const SolveOptions& options) {
  return complex_fluence(problem, {&rate, 1}, slowness, directions, options);
}

Slowness alike(const TetrahedralMesh& mesh, double slowness) {
  return Slowness(mesh.region_names().size(), slowness);
}

/// Media and walls of bands that are unlike each other.
Problem unlike_problem(const TetrahedralMesh& mesh, int bands, const PhaseFunction& phase) {
  Medium medium = uniform_medium(bands, 0, 0, 0, phase);
  Wall wall = uniform_wall(bands, 0, 0, 0);
  for (std::size_t b = 0; b < static_cast<std::size_t>(bands); ++b) {
    const auto number = static_cast<double>(b + 1);
    medium.absorption[b] = Coefficient(0.3 / number);
    medium.scattering[b] = Coefficient(2.0 * number);
    medium.emission[b] = Coefficient(0.7 * number);
    wall.radiance[b] = 0.9 + 0.1 * number;
    wall.diffuse[b] = 0.3 / number;
    wall.specular[b] = 0.2;
  }
  return uniform_problem(mesh, medium, wall);
}

/// Without an influence of the place: phi = 4 pi q / (sigma_a + s n / c).
TEST(LaplaceProblem, HasTheUniformSolutionBetweenMirrors) {
  const TetrahedralMesh mesh = cube_mesh(4e-2);
  for (const SpaceOrder order : {SpaceOrder::linear, SpaceOrder::constant})
    for (const int bands : {1, 2, 3, 5, 8}) {
      Medium medium = uniform_medium(bands, 0.5, 1.5, 0.25);
      for (std::size_t b = 0; b < static_cast<std::size_t>(bands); ++b)
        medium.absorption[b] = Coefficient(0.5 + static_cast<double>(b));
      const Problem problem = uniform_problem(mesh, medium, uniform_wall(bands, 0, 0, 1));
      const Complex rates[] = {{0, 2}, {1.5, 0.5}};
      SolveOptions options = tight_options();
      options.order = order;
      const std::vector<Complex> fluence =
          complex_fluence(problem, rates, alike(mesh, 1.5), directions_product(4), options);
      ASSERT_EQ(fluence.size(), static_cast<std::size_t>(8 * mesh.cell_count() * bands));
      for (std::size_t i = 0; i < fluence.size(); ++i) {
        const std::size_t band = i % static_cast<std::size_t>(bands);
        const Complex rate = rates[i / static_cast<std::size_t>(bands) % 2];
        const Complex expected = 4 * std::numbers::pi * 0.25 / (0.5 + static_cast<double>(band) + 1.5 * rate);
        EXPECT_LT(std::abs(fluence[i] - expected), 1e-10 * std::abs(expected)) << bands;
      }
    }
}

/// The solution is analytic in s: its mean over a circle is its value in the middle, where s is real and the
/// medium absorbs s n / c more. Of conjugate rates solutions are conjugate, so half of the circle says all.
void expect_mean_of_a_circle(const Problem& problem, const DirectionSet& directions, Lumping lumping) {
  constexpr int points = 8;  // of half the circle; the error is (radius / distance of the next pole)^16
  constexpr double middle = 2, radius = 0.35;
  const Slowness slowness = alike(problem.mesh(), 1);
  std::vector<Complex> rates;
  for (int k = 0; k < points; ++k)
    rates.push_back(middle + std::polar(radius, std::numbers::pi * (k + 0.5) / points));
  SolveOptions options = tight_options(lumping);
  options.tolerance = 1e-12;
  const std::vector<Complex> around = complex_fluence(problem, rates, slowness, directions, options);
  const std::vector<Complex> inside = complex_fluence(problem, middle, slowness, directions, options);
  const auto bands = static_cast<std::size_t>(problem.band_count());
  double largest = 0;
  for (const Complex& value : inside) largest = std::max(largest, std::abs(value));
  for (std::size_t i = 0; i < inside.size(); ++i) {
    const std::size_t node = i / bands, band = i % bands;
    double mean = 0;
    for (std::size_t k = 0; k < points; ++k)
      mean += around[(node * points + k) * bands + band].real() / points;
    EXPECT_EQ(inside[i].imag(), 0);
    ASSERT_NEAR(mean, inside[i].real(), 1e-9 * largest) << "band " << band;
  }
}

TEST(LaplaceProblem, IsAnalyticInTheRate) {
  const TetrahedralMesh mesh = cube_mesh(4e-2);
  for (const Lumping lumping : {Lumping::none, Lumping::mass, Lumping::automatic})
    expect_mean_of_a_circle(unlike_problem(mesh, 3, PhaseIsotropic{}), directions_product(4), lumping);
}

TEST(LaplaceProblem, IsAnalyticWithForwardScattering) {
  expect_mean_of_a_circle(unlike_problem(cube_mesh(4e-2), 1, PhaseHenyeyGreenstein{0.6}),
                          directions_product(6), Lumping::none);
}

TEST(LaplaceProblem, IsAnalyticAmongLeaves) {
  const TetrahedralMesh mesh = cube_mesh(8e-2);
  Medium medium = uniform_medium(2, 0.2, 2, 0.2);
  for (const double reflectance : {0.1, 0.3})
    medium.directional.emplace_back(LeafCanopy{LeafAngles::planophile, reflectance, 0.3});
  expect_mean_of_a_circle(uniform_problem(mesh, medium, uniform_wall(2, 0.3, 0.2, 0)), directions_product(4),
                          Lumping::none);
}

TEST(LaplaceProblem, IsAnalyticInThePlane) {
  const TetrahedralMesh mesh = cube_mesh(8e-2);
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names())
    walls.push_back(name[0] == 'z' ? uniform_wall(2, 0, 0, 1) : uniform_wall(2, 0.5, 0.3, 0));
  const Problem problem(mesh, {{"a", "b"}, {}}, {uniform_medium(2, 0.4, 2, 0.5)}, walls, AngularSpace::plane);
  expect_mean_of_a_circle(problem, directions_flatland(4), Lumping::none);
}

TEST(LaplaceProblem, IsAnalyticWithRefraction) {
  const TetrahedralMesh mesh = cube_mesh(8e-2);
  std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(1, 0.4, 0.2, 0));
  walls[0] = uniform_wall(1, 0, 0, 0);
  walls[0].refractive_index = 1.4;
  const Problem problem(mesh, {}, {uniform_medium(1, 0.4, 2, 0.5, PhaseHenyeyGreenstein{0.3})}, walls);
  expect_mean_of_a_circle(problem, directions_product(6), Lumping::none);
}

TEST(LaplaceProblem, IsAnalyticWithLampsOnTheDirections) {
  const TetrahedralMesh mesh = cube_mesh(8e-2);
  PointLight lamp;
  lamp.position = Vec3(0.4, 0.3, 0.6);
  lamp.power = {2, 3};
  const std::vector<Light> lights = {{"lamp", lamp, {}}};
  const std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(2, 0, 0.4, 0));
  const Problem problem(mesh, {{"a", "b"}, {}}, {uniform_medium(2, 0.4, 2, 0)}, walls, AngularSpace::sphere,
                        lights);
  expect_mean_of_a_circle(problem, directions_product(4), Lumping::none);
}

/// At a real rate the solution is that with more absorption.
TEST(LaplaceProblem, IsThatOfMoreAbsorptionForARealRate) {
  const TetrahedralMesh mesh = cube_with_ball(2e-2);
  Medium medium = uniform_medium(1, 0.3, 6, 0.7), darker = medium;
  darker.absorption[0] = Coefficient(0.3 + 1.2);
  const Wall wall = uniform_wall(1, 0.9, 0.5, 0.1);
  for (const Lumping lumping : {Lumping::none, Lumping::mass}) {
    const std::vector<Complex> fluence =
        complex_fluence(uniform_problem(mesh, medium, wall), 0.8, alike(mesh, 1.5), directions_product(4),
                        tight_options(lumping));
    const Solution expected =
        solve(uniform_problem(mesh, darker, wall), directions_product(4), tight_options(lumping));
    ASSERT_EQ(fluence.size(), expected.fluence.size());
    for (std::size_t i = 0; i < fluence.size(); ++i) {
      EXPECT_NEAR(fluence[i].real(), expected.fluence[i], 1e-10 * expected.fluence[i]);
      EXPECT_EQ(fluence[i].imag(), 0);
    }
  }
}

/// Rates that are solved side by side have the answers that each has alone, and those that take longer do
/// not change the others.
TEST(LaplaceProblem, HasEachRateAsAlone) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  const Problem problem = unlike_problem(mesh, 2, PhaseHenyeyGreenstein{0.4});
  const Complex rates[] = {{0, 0.1}, {0.5, 30}, {0, 3}};
  SolveOptions options = tight_options();
  options.tolerance = 1e-11;
  const std::vector<Complex> together =
      complex_fluence(problem, rates, alike(mesh, 1), directions_product(4), options);
  for (std::size_t k = 0; k < std::size(rates); ++k) {
    const std::vector<Complex> alone =
        complex_fluence(problem, rates[k], alike(mesh, 1), directions_product(4), options);
    ASSERT_EQ(together.size(), alone.size() * std::size(rates));
    double largest = 0;
    for (const Complex& value : alone) largest = std::max(largest, std::abs(value));
    for (std::size_t i = 0; i < alone.size(); ++i)
      EXPECT_LT(std::abs(together[(i / 2 * std::size(rates) + k) * 2 + i % 2] - alone[i]), 1e-9 * largest);
  }
}

/// Diffusion helps at every frequency: thick media take few sweeps, whether light is lost within a mean free
/// path or not.
TEST(LaplaceProblem, TakesFewSweepsInThickMedia) {
  const TetrahedralMesh mesh = cube_mesh(4e-3);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 0.001, 200, 1), uniform_wall(1, 0, 0, 0));
  for (const double frequency : {0.0, 0.01, 0.1, 1.0, 10.0, 1000.0}) {
    const Complex rate(0, frequency);
    const LaplaceProblem laplace = laplace_problem(problem, {&rate, 1}, alike(mesh, 1));
    SolveOptions options;
    options.added_extinction = &laplace.extinction;
    options.tolerance = 1e-6;
    const Solution solution = solve(laplace.problem, directions_product(4), options);
    EXPECT_TRUE(solution.converged());
    EXPECT_LE(solution.convergence[0].sweeps, 18) << frequency;
  }
}

TEST(LaplaceProblem, RefusesRatesOfGrowingOrConjugateLight) {
  const TetrahedralMesh mesh = cube_mesh(1);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 1, 0, 1), uniform_wall(1, 0, 0, 0));
  for (const Complex rate : {Complex(-1, 0), Complex(0, -1), Complex(std::nan(""), 0)})
    EXPECT_THROW(laplace_problem(problem, {&rate, 1}, alike(mesh, 1)), std::invalid_argument);
}

}  // namespace
}  // namespace etendue::laplace_problem_test
