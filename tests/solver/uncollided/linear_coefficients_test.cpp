// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Light along rays where formulas of the place give the coefficients.
#include "solver/angular/media/linear_coefficients.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/uncollided/lights/light_setup.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::linear_coefficients_test {
namespace {

Coefficient formula(const std::string& text) { return Coefficient(Expression(text, {"x", "y", "z"})); }

Medium smoke(const std::string& absorption, const std::string& scattering) {
  Medium medium = uniform_medium(1, 0, 0, 0);
  medium.absorption = {formula(absorption)};
  medium.scattering = {formula(scattering)};
  return medium;
}

/// A lamp in the cube, or the sun from above.
Problem lit(const TetrahedralMesh& mesh, const Medium& medium, bool by_lamp) {
  std::vector<Wall> walls;
  BeamLight sun{-Vec3::UnitZ(), {1}, {}};
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(uniform_wall(1, 0, 0, 0));
    walls.back().name = name;
    sun.walls.push_back(static_cast<int>(walls.size()) - 1);
  }
  PointLight lamp;
  lamp.position = {0.31, 0.47, 0.62};
  lamp.power = {1};
  if (by_lamp) return Problem(mesh, {}, {medium}, walls, AngularSpace::sphere, {{"lamp", lamp, {}}});
  return Problem(mesh, {}, {medium}, walls, AngularSpace::sphere, {{"sun", sun, {}}});
}

double fluence_at(const Problem& problem, const Vec3& place) {
  const CellIndex cell = CellLocator(problem.mesh()).find(place).front().cell;
  return LightSetup(problem).at({cell, place}, {}).fluence[0];
}

TEST(LinearCoefficients, KeepTheMeansAndAreExactWhereTheFormulaIsLinear) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  const Problem problem = lit(mesh, smoke("1 + 2*x - z", "exp(-20*z)"), false);
  const LinearCoefficients linear(problem);
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    EXPECT_TRUE(linear.varies(cell));
    for (const std::int32_t v : mesh.vertices(cell)) {
      const Vec3& p = mesh.points()[static_cast<std::size_t>(v)];
      EXPECT_NEAR(problem.absorption(cell, 0) + linear.absorption(cell, 0, p), 1 + 2 * p.x() - p.z(), 1e-12);
      // Steep as it is, nowhere negative.
      EXPECT_GE(problem.scattering(cell, 0) + linear.scattering(cell, 0, p), -1e-12);
    }
    EXPECT_NEAR(linear.scattering(cell, 0, mesh.centroid(cell)), 0, 1e-13);
  }
}

TEST(LinearCoefficients, LeaveNumbersAlone) {
  const TetrahedralMesh mesh = cube_mesh(0.05);
  EXPECT_TRUE(LinearCoefficients(uniform_problem(mesh, uniform_medium(1, 1, 2, 0), uniform_wall(1, 0, 0, 0)))
                  .empty());
}

// The optical depth of 1 + 2x - z from the lamp is its length times the value in the middle.
TEST(LightPaths, AreExactInLinearExtinction) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  const Vec3 lamp(0.31, 0.47, 0.62);
  const Problem of_lamp = lit(mesh, smoke("1 + 2*x - z", "0.3 + 0.1*y"), true);
  const Problem of_sun = lit(mesh, smoke("1 + 2*x - z", "0.3 + 0.1*y"), false);
  const auto extinction = [](const Vec3& p) { return 1.3 + 2 * p.x() - p.z() + 0.1 * p.y(); };
  for (const Vec3& place : {Vec3(0.7, 0.2, 0.3), Vec3(0.1, 0.9, 0.8), Vec3(0.95, 0.95, 0.05)}) {
    const double r = (place - lamp).norm();
    EXPECT_NEAR(fluence_at(of_lamp, place),
                std::exp(-r * extinction((place + lamp) / 2)) / (4 * std::numbers::pi * r * r), 1e-10);
    const double depth = 1 - place.z();
    EXPECT_NEAR(fluence_at(of_sun, place), std::exp(-depth * extinction(place + Vec3(0, 0, depth / 2))),
                1e-10);
  }
}

// Of other smooth smoke at second order and more: the sums over the cells of a ray even out.
TEST(LightPaths, ConvergeInSmoothExtinction) {
  double last = 0;
  for (const double volume : {0.02, 2.5e-3, 3e-4}) {
    const TetrahedralMesh mesh = cube_mesh(volume);
    const Problem problem = lit(mesh, smoke("2*exp(-2*z)", "0"), false);
    double squares = 0;
    const LightSetup lights(problem);
    const CellLocator locator(mesh);
    for (int i = 0; i < 100; ++i) {
      const Vec3 place(0.05 + 0.009 * i, 0.05 + 0.9 * std::fmod(0.37 * i, 1),
                       0.05 + 0.9 * std::fmod(0.61 * i, 1));
      const double exact = std::exp(-(std::exp(-2 * place.z()) - std::exp(-2.0)));
      const double found = lights.at({locator.find(place).front().cell, place}, {}).fluence[0];
      squares += (found - exact) * (found - exact) / 100;
    }
    const double error = std::sqrt(squares);
    if (last > 0) {
      EXPECT_GT(std::log2(last / error), 1.8);
    }
    last = error;
  }
}

// Thin cells have four points, which see the product of extinction and fluence to second degree: 3e-6.
TEST(UncollidedField, BalancesInVaryingExtinction) {
  const TetrahedralMesh mesh = cube_mesh(1e-3);
  for (const bool by_lamp : {true, false}) {
    const Problem problem = lit(mesh, smoke("1 + 2*x - z", "2*exp(-2*z)"), by_lamp);
    const LightSetup lights(problem);
    const UncollidedField field = uncollided_field(lights.paths(), lights.sources(), 1);
    double sum = 0;
    for (std::size_t c = 0; c < mesh.volumes().size(); ++c) {
      sum += mesh.volumes()[c] * field.absorbed[c];
      for (std::size_t i = 0; i < 4; ++i) sum += mesh.volumes()[c] * field.collided[c * 4 + i] / 4;
    }
    for (std::size_t i = 0; i < field.irradiance.size(); ++i)
      sum += field.irradiance[i] * mesh.area(FaceIndex(static_cast<std::int64_t>(i / 3))) / 3;
    EXPECT_NEAR(sum, lights.sources()[0]->power()[0], 5e-6);
  }
}

}  // namespace
}  // namespace etendue::linear_coefficients_test
