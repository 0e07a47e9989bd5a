// SPDX-License-Identifier: AGPL-3.0-or-later
// Derivatives by one adjoint solution and by central differences of runs.
#include "solver/adjoint/gradient.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numeric>
#include <string>

#include "base/errors.h"
#include "mesh/tetrahedra/corners.h"
#include "solver/adjoint/solve_adjoint.h"
#include "solver/transport/solve/solve.h"
#include "tests/mesh/tetrahedra/sample_meshes.h"
#include "tests/solver/adjoint/random_problem.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::gradient_test {
namespace {

constexpr std::size_t bands = 3;

using Change = std::function<void(std::vector<Medium>&, std::vector<Wall>&, double)>;

SolveOptions exact_options() {
  SolveOptions options = tight_options(Lumping::automatic);
  options.tolerance = 1e-13;
  options.precision = Precision::full;
  return options;
}

const TetrahedralMesh& coarse_mesh() {
  static const TetrahedralMesh mesh = two_region_mesh(0.2);
  return mesh;
}

/// A random problem whose media scatter by moments, with a change of some size.
Problem changed(unsigned seed, const Change& change, double size) {
  return random_problem(coarse_mesh(), seed, Rays::none, [&](auto& media, auto& walls) {
    for (Medium& medium : media)
      medium.choice.assign(bands, {ScatteringBackend::moments, 3, ForwardPeak::automatic});
    change(media, walls, size);
  });
}

/// [response][band] derivatives by the size of a change, by central differences.
std::vector<std::vector<double>> differences(unsigned seed, const Change& change, double step) {
  const DirectionSet directions = directions_product(4);
  const std::vector<Response> responses = random_responses(coarse_mesh(), seed);
  const auto more = responses_of_run(changed(seed, change, step), directions, responses, exact_options());
  auto result = responses_of_run(changed(seed, change, -step), directions, responses, exact_options());
  for (std::size_t r = 0; r < result.size(); ++r)
    for (std::size_t b = 0; b < bands; ++b) result[r][b] = (more[r][b] - result[r][b]) / (2 * step);
  return result;
}

/// A gradient with the response itself.
struct Found {
  Gradient gradient;
  std::vector<double> response;
};
Found found_gradient(const Problem& problem, const Response& response) {
  const DirectionSet directions = directions_product(4);
  const Solution solution = solve(problem, directions, exact_options());
  const AdjointSolution adjoint =
      solve_adjoint(emitter_sources(problem, 1), problem, {directions}, response, exact_options());
  return {gradient_of(problem, directions, response, exact_options(), solution, adjoint.importance),
          adjoint.response()};
}

/// Compares differences with what `derivative` makes of the gradient in each band.
void expect_derivatives(unsigned seed, const Change& change,
                        const std::function<double(const Gradient&, std::size_t band)>& derivative) {
  const auto expected = differences(seed, change, 1e-4);
  const Problem problem = changed(
      seed, [](auto&, auto&, double) {}, 0);
  const std::vector<Response> responses = random_responses(coarse_mesh(), seed);
  ASSERT_EQ(expected.size(), 4U);
  for (std::size_t r = 0; r < responses.size(); ++r) {
    const Found found = found_gradient(problem, responses[r]);
    for (std::size_t b = 0; b < bands; ++b)
      EXPECT_NEAR(derivative(found.gradient, b), expected[r][b], 1e-6 * std::abs(found.response[b]))
          << "seed " << seed << ", response " << r << ", band " << b;
  }
}

/// Sum over the cells of a region, or over all, of values [cell][band] times `weight`.
double sum_over_cells(
    const std::vector<double>& values, std::size_t band, int region,
    const std::function<double(CellIndex)>& weight = [](CellIndex) { return 1.0; }) {
  double sum = 0;
  for (std::int32_t c = 0; c < coarse_mesh().cell_count(); ++c)
    if (coarse_mesh().region(CellIndex(c)) == region)
      sum += weight(CellIndex(c)) * values[CellIndex(c).at() * bands + band];
  return sum;
}

double sum_over_wall(const std::vector<double>& values, std::size_t band, int wall) {
  double sum = 0;
  for (std::int32_t f = 0; f < coarse_mesh().boundary_face_count(); ++f)
    if (coarse_mesh().wall(FaceIndex(f)) == wall) sum += values[FaceIndex(f).at() * bands + band];
  return sum;
}

/// A coefficient times 1 + size x / 2, and the mean of x / 2 in a cell.
Coefficient tilted(const Coefficient& value, double size) {
  return Coefficient(
      Expression("(" + value.text() + ") * (1 + " + std::to_string(size) + " * x / 2)", {"x", "y", "z"}));
}
double mean_tilt(CellIndex cell) {
  double sum = 0;
  for (const Vec3& corner : corners_of(coarse_mesh(), cell)) sum += corner.x() / 8;
  return sum;
}

class GradientBy : public testing::TestWithParam<unsigned> {};

/// By a coefficient of each region, which is tilted in space.
void expect_by_coefficient(unsigned seed, std::vector<Coefficient> Medium::*list,
                           double (Problem::*value)(CellIndex, int) const,
                           std::vector<double> Gradient::*derivative) {
  const Problem problem = changed(
      seed, [](auto&, auto&, double) {}, 0);
  for (int region = 0; region < 2; ++region)
    expect_derivatives(
        seed,
        [&](auto& media, auto&, double size) {
          for (Coefficient& of_band : media[static_cast<std::size_t>(region)].*list)
            of_band = tilted(of_band, size);
        },
        [&](const Gradient& gradient, std::size_t b) {
          return sum_over_cells(gradient.*derivative, b, region, [&](CellIndex cell) {
            return mean_tilt(cell) * (problem.*value)(cell, static_cast<int>(b));
          });
        });
}

TEST_P(GradientBy, Absorption) {
  expect_by_coefficient(GetParam(), &Medium::absorption, &Problem::absorption, &Gradient::absorption);
}

TEST_P(GradientBy, Scattering) {
  expect_by_coefficient(GetParam(), &Medium::scattering, &Problem::scattering, &Gradient::scattering);
}

TEST_P(GradientBy, EmissionAndWalls) {
  expect_derivatives(
      GetParam(),
      [](auto& media, auto&, double size) {
        for (std::size_t b = 0; b < bands; b += 2)
          media[1].emission[b] = Coefficient(media[1].emission[b].at(Vec3::Zero()) + size);
        media[1].emission[1] =
            Coefficient(Expression("1 + x*y + z + " + std::to_string(size), {"x", "y", "z"}));
      },
      [](const Gradient& gradient, std::size_t b) { return sum_over_cells(gradient.emission, b, 1); });
  for (int wall = 0; wall < 6; wall += 2) {
    const auto number = static_cast<std::size_t>(wall);
    expect_derivatives(
        GetParam(),
        [&](auto&, auto& walls, double size) {
          for (double& value : walls[number].radiance) value += size + 1e-3;
        },
        [&](const Gradient& gradient, std::size_t b) { return sum_over_wall(gradient.radiance, b, wall); });
    expect_derivatives(
        GetParam(),
        [&](auto&, auto& walls, double size) {
          for (double& value : walls[number].diffuse) value += size;
        },
        [&](const Gradient& gradient, std::size_t b) { return sum_over_wall(gradient.diffuse, b, wall); });
  }
}

INSTANTIATE_TEST_SUITE_P(Random, GradientBy, testing::Range(20U, 22U));

TEST(Gradient, RefusesLightAlongRaysAndMatrices) {
  const TetrahedralMesh mesh(kuhn_cube_raw());
  const Response response = ArrivingPower{0};
  const Problem by_rays = random_problem(mesh, 1, Rays::from_lamp, [](auto& media, auto&) {
    for (Medium& medium : media)
      medium.choice.assign(bands, {ScatteringBackend::moments, 3, ForwardPeak::automatic});
  });
  EXPECT_THROW(found_gradient(by_rays, response), InputError);
  EXPECT_FALSE(found_gradient(on_directions(by_rays), response).gradient.absorption.empty());
  const Problem by_matrix = random_problem(mesh, 1, Rays::none, [](auto& media, auto&) {
    media[0].choice.assign(bands, {ScatteringBackend::dense, -1, ForwardPeak::automatic});
    media[0].phase.assign(bands, PhaseHenyeyGreenstein{0.5});
  });
  EXPECT_THROW(found_gradient(by_matrix, response), InputError);
}

}  // namespace
}  // namespace etendue::gradient_test
