// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Photons per millisecond of processor time on one core, and steps through cells per second: a pencil of
// light into a cube of 60 mm that scatters (1/mm, g = 0.01) and absorbs (0.005/mm), with open walls. The
// share that is absorbed is printed with its standard error.
#include <fmt/format.h>

#include <cstdlib>

#include "mesh/geometry/arrangement/arrangement.h"
#include "mesh/tetrahedra/generation/tetrahedralize.h"
#include "solver/photons/kernel/photon_kernel.h"
#include "solver/photons/solve/solve_photons.h"
#include "solver/solution/balance.h"

namespace etendue {
namespace {

TetrahedralMesh cube60(double max_volume) {
  Geometry geometry;
  BoxPrimitive box;
  box.region = "tissue";
  box.max = Vec3(60, 60, 60);
  geometry.primitives.emplace_back(box);
  return TetrahedralMesh(tetrahedralize(arrange(geometry), {{max_volume}, 1.4, {}}));
}

Problem lit_from_below(const TetrahedralMesh& mesh) {
  const Medium medium{"tissue",         {Coefficient(0.005)},          {Coefficient(1)},
                      {Coefficient(0)}, {PhaseHenyeyGreenstein{0.01}}, {}};
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) walls.push_back({name, {0}, {0}, {0}, {}});
  PointLight pencil;
  pencil.position = Vec3(30.02, 30.01, 1e-6);
  pencil.power = {1};
  pencil.angle = {0, 1e-6};
  pencil.intensity = {1, 1};
  return Problem(mesh, {}, {medium}, walls, AngularSpace::sphere, {{"pencil", pencil, {}}});
}

void measure(double max_volume, double photons) {
  const TetrahedralMesh mesh = cube60(max_volume);
  const Problem problem = lit_from_below(mesh);
  const CellLocator locator(mesh);
  PhotonOptions options;
  options.photons = photons;
  options.threads = 1;
  const PhotonSolution found = solve_photons(problem, locator, options, {}, [&](const Solution& batch) {
    return std::vector<double>{balances(problem, batch)[0].absorbed};
  });
  const PhotonReport& report = found.report;
  fmt::print(
      "{} kernel, {} cells: {:.0f} photons/ms, {:.1f} million steps/s, {:.1f} steps and {:.1f} collisions a "
      "photon; absorbed {:.3f} +- {:.3f} %\n",
      choose_photon_kernels().name, mesh.cell_count(), 1e-3 * report.histories / report.seconds,
      1e-6 * report.segments / report.seconds, report.segments / report.histories,
      report.collisions / report.histories, 100 * found.sums.derived.mean(0),
      100 * found.sums.derived.error(0));
}

}  // namespace
}  // namespace etendue

int main(int count, char** arguments) {
  const double photons = count > 1 ? std::atof(arguments[1]) : 1e6;
  etendue::measure(75, photons);
  etendue::measure(13, photons);
}
