// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Rooms with glossy walls by ordinates, by photons and in pictures.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "solver/materials/surfaces/microfacets.h"
#include "solver/materials/surfaces/phong.h"
#include "solver/materials/surfaces/ward.h"
#include "solver/observe/photon_map/map_radiance.h"
#include "solver/observe/radiance/ray_radiance.h"
#include "solver/photons/solve/solve_photons.h"
#include "solver/solution/balance.h"
#include "solver/uncollided/first_collision/solve_split.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::glossy_room_test {
namespace {

using std::numbers::pi;

const TetrahedralMesh& cube() {
  static const TetrahedralMesh mesh = cube_mesh(1e-2);
  return mesh;
}

/// The floor is glossy, the wall at x = 0 shines, the others reflect a little.
Problem glossy_room(std::shared_ptr<const Reflectance> lobe, double shining, std::vector<Light> lights = {}) {
  std::vector<Wall> walls;
  for (const std::string& name : cube().wall_names()) {
    walls.push_back(uniform_wall(1, name == "xmin" ? shining : 0, name == "zmin" ? 0.1 : 0.3, 0));
    if (name == "zmin") walls.back().glossy = {lobe};
    walls.back().name = name;
  }
  return Problem(cube(), {}, {uniform_medium(1, 0.1, 0.2, 0)}, walls, AngularSpace::sphere,
                 std::move(lights));
}

std::vector<double> incoming(const Problem& problem, const Solution& solution) {
  std::vector<double> powers;
  for (const auto& wall : wall_powers(problem, solution)) powers.push_back(wall[0].incoming);
  return powers;
}

PhotonSolution by_photons(const Problem& problem, double photons) {
  const CellLocator locator(problem.mesh());
  PhotonOptions options;
  options.photons = photons;
  options.threads = 2;
  return solve_photons(problem, locator, options, {},
                       [&](const Solution& batch) { return incoming(problem, batch); });
}

/// What arrives at each wall, by ordinates within 1.5 % and three errors of the photons.
void expect_agreement(const Problem& problem) {
  const Solution ordinates = solve_split(LightSetup(problem), directions_ldfe_sq(2), tight_options());
  const PhotonSolution photons = by_photons(problem, 40000);
  EXPECT_LT(std::abs(balances(problem, ordinates)[0].residual), 5e-3);
  EXPECT_LT(std::abs(balances(problem, photons.solution)[0].residual), 1e-2);
  const std::vector<double> found = incoming(problem, ordinates);
  for (std::size_t w = 0; w < found.size(); ++w)
    EXPECT_NEAR(found[w], photons.sums.derived.mean(w),
                3 * photons.sums.derived.error(w) + 0.015 * photons.sums.derived.mean(w))
        << problem.wall(static_cast<int>(w)).name;
}

TEST(GlossyRoom, OrdinatesAndPhotonsAgree) {
  expect_agreement(glossy_room(std::make_shared<Phong>(0.8, 20), 1));
  expect_agreement(glossy_room(std::make_shared<Microfacets>(0.8, 0.3, FacetFresnel::constant), 1));
  expect_agreement(glossy_room(std::make_shared<Ward>(0.9, 0.25), 1));
}

// The first reflection of a lamp's light enters the sweep by its exact directions.
TEST(GlossyRoom, ALampIsReflected) {
  PointLight point;
  point.position = {0.4, 0.5, 0.6};
  point.power = {4 * pi};
  const Problem problem =
      glossy_room(std::make_shared<Microfacets>(0.8, 0.4, FacetFresnel::constant), 0, {{"lamp", point, {}}});
  const LightSetup lights(problem);
  const Solution solution = solve_split(lights, directions_ldfe_sq(1), tight_options());
  EXPECT_NEAR(solution.lights.balance[0].residual, 0, 5e-3);
  expect_agreement(problem);
}

// A slant beam that enters by the ceiling onto the floor: all that is reflected is f_r E, towards any eye.
TEST(GlossyRoom, ThePictureOfABeamIsExact) {
  const auto lobe = std::make_shared<Phong>(0.9, 40);
  const auto& names = cube().wall_names();
  const int ceiling = static_cast<int>(std::ranges::find(names, "zmax") - names.begin());
  const Vec3 travel = Vec3(0.5, 0, -1).normalized();
  std::vector<Wall> walls(names.size(), uniform_wall(1, 0, 0, 0));
  for (std::size_t w = 0; w < names.size(); ++w) {
    walls[w].name = names[w];
    if (names[w] == "zmin") walls[w].glossy = {lobe};
  }
  const Problem problem(cube(), {}, {uniform_medium(1, 0, 0, 0)}, walls, AngularSpace::sphere,
                        {{"sun", BeamLight{travel, {2}, {ceiling}}, {}}});
  const LightSetup lights(problem);
  const DirectionSet set = directions_ldfe_sq(1);
  const SolveOptions options = tight_options();
  const Solution solution = solve_split(lights, set, options);
  const RayRadiance scene(lights, set, options, solution.state, 1);
  RayRadiance::Workspace work(scene);
  std::vector<double> value(1);
  // To a lit point and to one in the shadow of the wall.
  for (const double x : {0.9, 0.3}) {
    const Vec3 from(0.99, 0.5, 0.7), towards = (Vec3(x, 0.5, 0) - from).normalized();
    scene.along(*scene.enter(from, towards), towards, {}, work, value);
    const double lit = x > 0.5 ? 2 * -travel.z() : 0;
    EXPECT_NEAR(value[0], lobe->between(travel, -towards, Vec3::UnitZ()) * lit, 1e-9) << x;
  }
}

// A furnace with a glossy floor that emits what it does not reflect looks alike everywhere, in pictures from
// ordinates and from photons.
TEST(GlossyRoom, AFurnaceLooksAlikeEverywhere) {
  const double u = 2;
  const auto lobe = std::make_shared<Phong>(0.6, 1);
  std::vector<Wall> walls;
  for (const std::string& name : cube().wall_names()) {
    walls.push_back(uniform_wall(1, 0.6 * u, 0.4, 0));
    walls.back().name = name;
    if (name != "zmin") continue;
    walls.back() = uniform_wall(1, 0, 0, 0);
    walls.back().name = name;
    walls.back().glossy = {lobe};
    walls.back().radiance_by_direction = {
        AngularFormula("2*(1-0.6/3.141592653589793*(sqrt(1-wz*wz)+(3.141592653589793-acos(wz))*wz))")};
  }
  const Problem problem(cube(), {}, {uniform_medium(1, 0.3, 0.5, 0.3 * u)}, walls);
  const LightSetup lights(problem);
  const DirectionSet set = directions_ldfe_sq(1);
  const SolveOptions options = tight_options();
  const Solution solution = solve_split(lights, set, options);
  EXPECT_LT(largest_deviation(solution.fluence, 4 * pi * u), 1e-8);
  const RayRadiance scene(lights, set, options, solution.state, 1);
  RayRadiance::Workspace work(scene);
  std::vector<double> value(1);
  for (const Vec3& to : {Vec3(0.3, 0.6, 0), Vec3(0.9, 0.2, 0), Vec3(0.5, 0.5, 0)}) {
    const Vec3 from(0.45, 0.5, 0.9), towards = (to - from).normalized();
    scene.along(*scene.enter(from, towards), towards, {.glossy = 4096}, work, value);
    // The rays are a sample of the lobe.
    EXPECT_NEAR(value[0], u, 2e-3 * u);
  }
}

// The estimate from hits is f_r times what they bring: under a beam, f_r E.
TEST(GlossyRoom, ThePhotonMapKnowsTheLobe) {
  const auto lobe = std::make_shared<Phong>(0.9, 10);
  const auto& names = cube().wall_names();
  const int ceiling = static_cast<int>(std::ranges::find(names, "zmax") - names.begin());
  const Vec3 travel = Vec3(0.2, 0, -1).normalized();
  std::vector<Wall> walls(names.size(), uniform_wall(1, 0, 0, 0));
  std::int32_t floor = -1;
  for (std::size_t w = 0; w < names.size(); ++w) {
    walls[w].name = names[w];
    if (names[w] == "zmin") walls[w].glossy = {lobe};
  }
  const Problem problem(cube(), {}, {uniform_medium(1, 0, 0, 0)}, walls, AngularSpace::sphere,
                        {{"sun", BeamLight{travel, {2}, {ceiling}}, {}}});
  const Vec3 point(0.6, 0.5, 0);
  for (std::int32_t f = 0; f < cube().boundary_face_count(); ++f)
    if (std::abs(cube().area_normal(FaceIndex(f)).normalized().z() + 1) < 1e-9 &&
        (cube().centroid(FaceIndex(f)) - point).norm() < 0.1)
      floor = f;
  ASSERT_GE(floor, 0);
  const MapRadiance map(problem, keep_hits(problem, CellLocator(cube()), {40000, 1e6, 400, 1, 2}), 400);
  MapRadiance::Workspace work;
  const Vec3 out = Vec3(0.3, 0.1, 0.9).normalized();
  const Estimate found = map.reflected(FaceIndex(floor), cube().centroid(FaceIndex(floor)), out, 0, work);
  const double exact = lobe->between(travel, out, Vec3::UnitZ()) * 2 * -travel.z();
  EXPECT_NEAR(found.value, exact, 3 * found.error);
  EXPECT_LT(found.error, 0.06 * exact);
}

}  // namespace
}  // namespace etendue::glossy_room_test
