// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Lights in media whose coefficients depend on the direction.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>

#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/materials/kernels/leaf_canopy.h"
#include "solver/materials/kernels/micro_flakes.h"
#include "solver/uncollided/lights/light_setup.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::directional_light_test {
namespace {

constexpr double density = 1.3;

KernelFormula formula(const std::string& text) {
  KernelFormula kernel;
  kernel.formula = std::make_shared<Expression>(text, kernel_variables());
  return kernel;
}

Medium with(DirectionalScattering matter, double absorption, double scattering) {
  Medium medium = uniform_medium(1, absorption, scattering, 0);
  medium.directional = {std::move(matter)};
  return medium;
}

Medium leaves(LeafAngles angles) {
  return with(LeafCanopy{angles, 0.2, 0.1}, density * 0.5 * 0.7, density * 0.5 * 0.3);
}

Medium flakes() {
  const MicroFlakes shape{Vec3(1, 0, 1).normalized(), 1, 0.2, 0.6};
  const double mean = mean_flake_projection(shape);
  return with(shape, density * mean * 0.4, density * mean * 0.6);
}

/// What scatters out of w is 0.8 (1 + 0.5 wz^2), in the mean 0.8 (1 + 1/6).
Medium by_formula() {
  return with(formula("0.8*(1 + 0.5*wz^2)*(1 + 0.4*(wx*vx + wy*vy + wz*vz))/(4*pi)"), 0.3,
              0.8 * (1 + 1. / 6));
}

Medium absorbing(const std::string& text) {
  Medium medium = uniform_medium(1, 0.7, 0.4, 0);
  medium.absorption_by_direction = {AngularFormula(text)};
  return medium;
}

enum class Lamp { point, sun, wall };

Problem lit(const TetrahedralMesh& mesh, const Medium& medium, Lamp lamp,
            const Vec3& direction = -Vec3::UnitZ()) {
  std::vector<Wall> walls;
  std::vector<Light> lights;
  BeamLight sun{direction, {1}, {}};
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(uniform_wall(1, 0, 0, 0));
    walls.back().name = name;
    if (name == "zmax" && lamp == Lamp::wall) {
      walls.back().radiance = {1};
      walls.back().uncollided = Uncollided::yes;
    }
    sun.walls.push_back(static_cast<int>(walls.size()) - 1);
  }
  PointLight point;
  point.position = {0.31, 0.47, 0.62};
  point.power = {1};
  if (lamp == Lamp::point) lights.push_back({"lamp", point, {}});
  if (lamp == Lamp::sun) lights.push_back({"sun", sun, {}});
  return Problem(mesh, {}, {medium}, walls, AngularSpace::sphere, lights);
}

struct Powers {
  double absorbed = 0, collided = 0, arrived = 0, sent = 0;
  double residual() const { return (sent - absorbed - collided - arrived) / sent; }
};

Powers powers_of(const LightSetup& lights) {
  const TetrahedralMesh& mesh = lights.problem().mesh();
  const UncollidedField field = uncollided_field(lights.paths(), lights.sources(), 2);
  Powers powers;
  for (std::size_t c = 0; c < mesh.volumes().size(); ++c) {
    powers.absorbed += mesh.volumes()[c] * field.absorbed[c];
    for (std::size_t i = 0; i < 4; ++i) powers.collided += mesh.volumes()[c] * field.collided[c * 4 + i] / 4;
  }
  for (std::size_t i = 0; i < field.irradiance.size(); ++i)
    powers.arrived += field.irradiance[i] * mesh.area(FaceIndex(static_cast<std::int64_t>(i / 3))) / 3;
  powers.sent = lights.sources()[0]->power()[0];
  return powers;
}

PointInCell place_in(const TetrahedralMesh& mesh, const Vec3& point) {
  return {CellLocator(mesh).find(point).front().cell, point};
}

// Extinction u_L G(w) along the beam, which goes 0.75/|mu| deep: closed forms of G for level leaves, |mu|;
// for leaves as the surface of a ball, 1/2; for upright ones, (2/pi) sin.
TEST(DirectionalLight, OfABeamFallsOffAsLeavesStand) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  const Vec3 direction = Vec3(0.2, -0.1, -1).normalized();
  const double slope = -direction.z(), side = std::sqrt(1 - slope * slope);
  const std::vector<std::pair<LeafAngles, double>> expected = {
      {LeafAngles::horizontal, slope},
      {LeafAngles::spherical, 0.5},
      {LeafAngles::vertical, 2 / std::numbers::pi * side}};
  for (const auto& [angles, projection] : expected) {
    const Problem problem = lit(mesh, leaves(angles), Lamp::sun, direction);
    const LightSetup lights(problem);
    const double found = lights.at(place_in(mesh, {0.5, 0.5, 0.25}), {}).fluence[0];
    EXPECT_NEAR(found, std::exp(-density * projection * 0.75 / slope), 1e-10);
  }
}

TEST(DirectionalLight, OfAPointFallsOffAsEachWaySees) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  const Vec3 lamp(0.31, 0.47, 0.62), place(0.7, 0.2, 0.3);
  const Vec3 separation = place - lamp;
  const double r = separation.norm();
  const auto expected = [&](double extinction) {
    return std::exp(-extinction * r) / (4 * std::numbers::pi * r * r);
  };
  const auto found = [&](const Medium& medium) {
    const Problem problem = lit(mesh, medium, Lamp::point);
    return LightSetup(problem).at(place_in(mesh, place), {}).fluence[0];
  };
  const Vec3 w = separation / r;
  EXPECT_NEAR(found(leaves(LeafAngles::planophile)),
              expected(density * leaf_projection(LeafAngles::planophile, w)), 1e-10);
  EXPECT_NEAR(found(flakes()),
              expected(density * flake_projection({Vec3(1, 0, 1).normalized(), 1, 0.2, 0.6}, w)), 1e-10);
  // By a table of what the formula scatters.
  EXPECT_NEAR(found(by_formula()), expected(0.3 + 0.8 * (1 + 0.5 * w.z() * w.z())), 1e-6);
  // Light, not the ray that looks for it: 0.7 + 0.2 wx is another number backwards.
  EXPECT_NEAR(found(absorbing("0.7 + 0.2*wx")), expected(0.4 + 0.7 + 0.2 * w.x()), 1e-10);
}

TEST(DirectionalLight, BalancesAsInOtherMatter) {
  const TetrahedralMesh mesh = cube_mesh(5e-3);
  const Vec3 slanting = Vec3(0.2, -0.1, -1).normalized();
  const auto residual = [&](const Medium& medium, Lamp lamp) {
    const Problem problem = lit(mesh, medium, lamp, slanting);
    return std::abs(powers_of(LightSetup(problem)).residual());
  };
  for (const Medium& medium : {absorbing("0.7 + 0*wx"), leaves(LeafAngles::planophile), flakes(),
                               by_formula(), absorbing("0.7 + 0.2*wx"), absorbing("0.7 + 0.2*wx*x")}) {
    EXPECT_LT(residual(medium, Lamp::point), 5e-7);
    EXPECT_LT(residual(medium, Lamp::sun), 1e-6);
  }
  // What leaves that lie flat take bends where light runs along them.
  EXPECT_LT(residual(leaves(LeafAngles::horizontal), Lamp::point), 5e-5);
  EXPECT_LT(residual(leaves(LeafAngles::horizontal), Lamp::sun), 1e-6);
}

// From a whole ceiling light comes in all directions; how much leaves that lie flat or stand upright take of
// it differs most between these. Where nothing differs the rules of other media are left.
TEST(DirectionalLight, OfAWallBalances) {
  const TetrahedralMesh mesh = cube_mesh(0.05);
  const auto residual = [&](const Medium& medium) {
    const Problem problem = lit(mesh, medium, Lamp::wall);
    return std::abs(powers_of(LightSetup(problem)).residual());
  };
  for (const LeafAngles angles : {LeafAngles::horizontal, LeafAngles::planophile, LeafAngles::vertical})
    EXPECT_LT(residual(leaves(angles)), 1e-3);
  EXPECT_LT(residual(flakes()), 1e-3);
  EXPECT_LT(residual(leaves(LeafAngles::spherical)), 1e-5);
}

/// Between opposite sides of length 1 at this distance (Hottel; Howell, C-11).
double form_factor_of_squares(double distance) {
  const double x = 1 / distance, root = std::sqrt(1 + x * x);
  return 2 / (std::numbers::pi * x * x) *
         (std::log((1 + x * x) / std::sqrt(1 + 2 * x * x)) + 2 * x * root * std::atan(x / root) -
          2 * x * std::atan(x));
}

// Flat leaves leave e^(-u_L d) in a depth d, whatever the direction: of what goes down through a plane there,
// pi F(d) e^(-u_L d) of a ceiling of radiance 1, they take u_L in each length.
TEST(DirectionalLight, OfACeilingIsLostInFlatLeavesAsInClosedForm) {
  const TetrahedralMesh mesh = cube_mesh(5e-3);
  constexpr int steps = 1000;
  double lost = 0;
  for (int i = 0; i < steps; ++i) {
    const double depth = (i + 0.5) / steps;
    lost += density * std::exp(-density * depth) * form_factor_of_squares(depth) / steps;
  }
  const Problem problem = lit(mesh, leaves(LeafAngles::horizontal), Lamp::wall);
  const Powers powers = powers_of(LightSetup(problem));
  EXPECT_NEAR((powers.absorbed + powers.collided) / powers.sent, lost, 1e-4);
  EXPECT_NEAR(powers.residual(), 0, 5e-4);
}

TEST(DirectionalLight, OfRoundFlakesIsThatOfOrdinaryMatter) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  for (const Lamp lamp : {Lamp::point, Lamp::sun, Lamp::wall}) {
    const Problem ordinary = lit(mesh, uniform_medium(1, 0.4, 0.6, 0), lamp);
    const Problem round = lit(mesh, with(MicroFlakes{Vec3::UnitZ(), 1, 1, 0.6}, 0.4, 0.6), lamp);
    const LightSetup of_ordinary(ordinary), of_round(round);
    const UncollidedField a = uncollided_field(of_ordinary.paths(), of_ordinary.sources(), 1);
    const UncollidedField b = uncollided_field(of_round.paths(), of_round.sources(), 1);
    EXPECT_TRUE(a.absorbed.empty());
    for (std::size_t i = 0; i < a.fluence.size(); ++i) {
      EXPECT_NEAR(a.fluence[i], b.fluence[i], 1e-11);
      EXPECT_NEAR(0.6 * a.fluence[i], b.collided[i], 1e-11);
    }
  }
}

TEST(DirectionalLight, IsRefusedBesideMatricesAndKernelsOfEachPlace) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  KernelMatrix matrix;
  matrix.count = 96;
  matrix.values.assign(96 * 96, 0.01);
  const Medium of_place = with(formula("exp((wx*vx + wy*vy + wz*vz)*x)/(4*pi)"), 0.1, 1);
  for (const Medium& medium : {with(matrix, 0.1, 0.1), of_place}) {
    const Problem problem = lit(mesh, medium, Lamp::point);
    EXPECT_THROW(LightSetup{problem}, InputError);
  }
}

}  // namespace
}  // namespace etendue::directional_light_test
