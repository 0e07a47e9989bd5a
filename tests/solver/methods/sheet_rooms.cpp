// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/solver/methods/sheet_rooms.h"

#include <algorithm>

#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/uncollided/first_collision/solve_split.h"

namespace etendue {

Problem room(const TetrahedralMesh& mesh, const Medium& medium, const std::map<std::string, Surface>& named,
             const Surface& other, std::vector<Light> lights) {
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    const auto found = named.find(name);
    const Surface surface = found == named.end() ? other : found->second;
    walls.push_back(uniform_wall(1, surface.radiance, surface.diffuse, surface.specular));
    walls.back().transmittance = {surface.transmittance};
    walls.back().name = name;
  }
  return Problem(mesh, {}, std::vector<Medium>(mesh.region_names().size(), medium), walls,
                 AngularSpace::sphere, std::move(lights));
}

Solution by_ordinates(const Problem& problem) {
  return solve_split(LightSetup(problem), directions_ldfe_sq(1), tight_options());
}

Solution by_radiosity(const Problem& problem, RadiosityMethod method, double patch_size) {
  RadiosityOptions options;
  options.method = method;
  options.patch_size = patch_size;
  options.limits = {1e-10, 2000};
  return RadiosityRoom(problem, options).solve();
}

std::size_t wall_number(const Problem& problem, const std::string& wall) {
  const auto& names = problem.mesh().wall_names();
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), wall) - names.begin());
}

WallPower power_on(const Problem& problem, const Solution& solution, const std::string& wall) {
  return wall_powers(problem, solution)[wall_number(problem, wall)][0];
}

PhotonSolution by_photons(const Problem& problem, double photons) {
  const CellLocator locator(problem.mesh());
  PhotonOptions options;
  options.photons = photons;
  options.threads = 2;
  return solve_photons(problem, locator, options, {}, [&](const Solution& batch) {
    std::vector<double> incoming;
    for (const std::string& wall : problem.mesh().wall_names())
      incoming.push_back(power_on(problem, batch, wall).incoming);
    return incoming;
  });
}

}  // namespace etendue
