// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Beams with a cross-section along rays and by photons, in media that scatter forward. The two share the
// walls that a beam lights and its irradiance there, but neither its directions behind them nor its rays.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/photons/solve/solve_photons.h"
#include "solver/solution/balance.h"
#include "solver/uncollided/first_collision/solve_split.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::beam_by_photons_test {
namespace {

using enum BeamProfile::Shape;

struct Scene {
  const char* name;
  BeamProfile::Shape shape;
  double radius;
  Vec3 direction;                ///< of travel, in the domain
  double refractive_index = 1;   ///< of the top by which it comes in
  double floor_reflectance = 0;  ///< a mirror's
};

int place_of(const std::vector<std::string>& names, const char* name) {
  return static_cast<int>(std::ranges::find(names, name) - names.begin());
}

/// 1 W through the top of the unit cube, of which the ball in the middle absorbs more than the rest.
Problem with_beam(const TetrahedralMesh& mesh, const Scene& scene) {
  const Vec3 along = scene.direction.normalized(), across = along.unitOrthogonal();
  const int top = place_of(mesh.wall_names(), "zmax");
  const BeamProfile profile{
      scene.shape, {0.45, 0.52, 1}, across / scene.radius, along.cross(across) / scene.radius};
  const double irradiance = 1 / profile_area(scene.shape, scene.radius);
  std::vector<Medium> media(mesh.region_names().size(),
                            uniform_medium(1, 0.4, 3, 0, PhaseHenyeyGreenstein{0.9}));
  media[static_cast<std::size_t>(place_of(mesh.region_names(), "ball"))].absorption = {Coefficient(2.0)};
  std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(1, 0, 0, 0));
  for (std::size_t w = 0; w < walls.size(); ++w) walls[w].name = mesh.wall_names()[w];
  walls[static_cast<std::size_t>(top)].refractive_index = scene.refractive_index;
  walls[static_cast<std::size_t>(place_of(mesh.wall_names(), "zmin"))].specular = {scene.floor_reflectance};
  const BeamLight beam{along, {irradiance}, {top}, 0, profile};
  return Problem(mesh, {}, std::move(media), std::move(walls), AngularSpace::sphere,
                 {Light{"beam", beam, {}}});
}

/// Powers that the ball and the rest absorb and that the floor and the other walls take.
std::vector<double> powers(const Problem& problem, const Solution& solution) {
  std::vector<double> found;
  for (const std::vector<RegionPower>& region : region_powers(problem, solution))
    found.push_back(region[0].absorbed);
  for (const std::vector<WallPower>& wall : wall_powers(problem, solution)) found.push_back(wall[0].incoming);
  return found;
}

// To 0.4 % of the beam on these cells and 384 directions.
TEST(BeamByPhotons, AgreesWithRays) {
  const TetrahedralMesh mesh = cube_with_ball(0.002);
  const CellLocator locator(mesh);
  SolveOptions options_for_rays;
  options_for_rays.tolerance = 1e-4;
  for (const Scene& scene :
       {Scene{"disc", disc, 0.1, {0, 0, -1}}, Scene{"pencil", disc, 0.002, {0.05, 0, -1}},
        Scene{"slanting Gaussian", gaussian, 0.12, {0.4, 0.2, -1}},
        Scene{"Gaussian behind glass", gaussian, 0.12, {0.2, 0, -1}, 1.37},
        Scene{"disc over a mirror", disc, 0.1, {0.2, 0.1, -1}, 1, 0.8}}) {
    const Problem problem = with_beam(mesh, scene);
    PhotonOptions options;
    options.photons = 2e5;
    options.threads = 2;
    const Solution photons = solve_photons(problem, locator, options).solution;
    const LightSetup lights(problem);
    const Solution rays = solve_split(lights, directions_ldfe_sq(2), options_for_rays);
    EXPECT_NEAR(balances(problem, rays)[0].inflow / balances(problem, photons)[0].inflow, 1, 1e-6);
    const std::vector<double> expected = powers(problem, photons), found = powers(problem, rays);
    for (std::size_t i = 0; i < found.size(); ++i)
      EXPECT_NEAR(found[i], expected[i], 0.004) << scene.name << i;
  }
}

}  // namespace
}  // namespace etendue::beam_by_photons_test
