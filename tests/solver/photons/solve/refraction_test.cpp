// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Photons at smooth walls with a medium of another refractive index behind them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/photons/solve/probe_histories.h"
#include "solver/photons/solve/solve_photons.h"
#include "solver/problem/mirror.h"
#include "solver/solution/balance.h"
#include "tests/solver/photons/solve/photon_samples.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::refraction_test {
namespace {

using std::numbers::pi;

Wall surface_of_index(double index, double radiance_behind) {
  Wall wall = uniform_wall(1, radiance_behind, 0, 0);
  wall.refractive_index = index;
  return wall;
}

std::size_t floor_of(const TetrahedralMesh& mesh) {
  return static_cast<std::size_t>(std::ranges::find(mesh.wall_names(), "zmin") - mesh.wall_names().begin());
}

Problem between_mirrors(const TetrahedralMesh& mesh, const Medium& medium, const Wall& floor,
                        std::vector<Light> lights = {}) {
  std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(1, 0, 0, 1));
  walls[floor_of(mesh)] = floor;
  return Problem(mesh, {}, {medium}, walls, AngularSpace::sphere, std::move(lights));
}

// In equilibrium the radiance is n^2 times that of empty space (Planck 1914, section 38), inside and on the
// way back from a point.
TEST(Refraction, KeepsTheEquilibriumWithWhatIsBehind) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  for (const double index : {0.75, 1.5}) {
    const double radiance = index * index;
    const Problem problem =
        between_mirrors(mesh, uniform_medium(1, 0.3, 1, 0.3 * radiance), surface_of_index(index, 1));
    const PhotonSolution found = solved(problem, 20000, [&](const Solution& batch) {
      const WallPower lit = wall_powers(problem, batch)[floor_of(mesh)][0];
      return std::vector<double>{lit.outgoing - lit.incoming};
    });
    double square = 0;
    for (std::size_t c = 0; c < found.sums.cell_means.size(); ++c)
      square +=
          std::pow((found.sums.cell_means.mean(c) - 4 * pi * radiance) / found.sums.cell_means.error(c), 2);
    EXPECT_NEAR(square / static_cast<double>(found.sums.cell_means.size()), 1, 0.3) << index;
    EXPECT_LT(std::abs(found.sums.derived.mean(0)), 3 * found.sums.derived.error(0));
    const WallPower lit = wall_powers(problem, found.solution)[floor_of(mesh)][0];
    EXPECT_NEAR(lit.emitted, pi * (1 - mirrored_part_of_isotropic(surface_of_index(1 / index, 0), 0)), 2e-3);
    const CellLocator locator(mesh);
    const auto seen = walk_back_from({{Vec3(0.4, 0.5, 0.2), {}}, {Vec3(0.5, 0.5, 0), Vec3(0, 0, 1)}}, problem,
                                     locator, {4000, 1, 2});
    EXPECT_NEAR(seen[0][0].fluence.value, 4 * pi * radiance, 3 * seen[0][0].fluence.error);
    EXPECT_NEAR(seen[1][0].irradiance->value, pi * radiance, 3 * seen[1][0].irradiance->error);
    EXPECT_LT(seen[0][0].fluence.error, 0.05 * radiance);
  }
}

// Nothing absorbs, so that all that comes in by the surface leaves there, whatever it turns back.
TEST(Refraction, LetsOutWhatCameIn) {
  const TetrahedralMesh mesh = cube_mesh(0.05);
  const Problem problem = between_mirrors(mesh, uniform_medium(1, 0, 2, 0), surface_of_index(1.33, 1));
  const PhotonSolution found = solved(problem, 20000, [&](const Solution& batch) {
    return std::vector<double>{balances(problem, batch)[0].residual};
  });
  EXPECT_LT(std::abs(found.sums.derived.mean(0)), 3 * found.sums.derived.error(0));
  EXPECT_LT(found.sums.derived.error(0), 1e-3);
}

// validation/reference/mcml_half_space.csv: Giovanelli (1955), total reflectance of a half-space of albedo
// 0.9 and index 1.5 lit straight on, with the 0.04 that the surface turns back at once.
TEST(Refraction, FindsGiovanellisReflectance) {
  const TetrahedralMesh mesh = cube_mesh(0.05);
  const auto floor = static_cast<int>(floor_of(mesh));
  const Problem problem = between_mirrors(mesh, uniform_medium(1, 3, 27, 0), surface_of_index(1.5, 0),
                                          {{"beam", BeamLight{Vec3::UnitZ(), {0.96}, {floor}}, {}}});
  const PhotonSolution found = solved(problem, 40000, [&](const Solution& batch) {
    return std::vector<double>{0.04 + balances(problem, batch)[0].outflow};
  });
  EXPECT_NEAR(found.sums.derived.mean(0), 0.2600, 3 * found.sums.derived.error(0));
  EXPECT_LT(found.sums.derived.error(0), 0.003);
}

}  // namespace
}  // namespace etendue::refraction_test
