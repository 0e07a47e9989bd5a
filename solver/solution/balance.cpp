// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/solution/balance.h"

#include <cstddef>

#include "base/field_view.h"
#include "solver/problem/mirror.h"

namespace etendue {
namespace {

double ratio(double part, double whole) { return whole > 0 ? part / whole : 0; }

/// Adds one boundary face to the powers of its wall. The means are integrals until all faces are in.
void add_face(WallPower& power, const Problem& problem, const Solution& solution, FaceIndex face,
              std::size_t band) {
  const std::size_t bands = problem.bands().names.size();
  const double area = problem.mesh().area(face);
  const int wall = problem.mesh().wall(face);
  const Wall& behind = problem.wall(wall);
  const double radiance = behind.radiance[band] + problem.following_radiance(face, static_cast<int>(band));
  power.area += area;
  power.incoming += ConstFaceField(solution.irradiance, bands).mean(face, band) * area;
  power.outgoing += ConstFaceField(solution.exitance, bands).mean(face, band) * area;
  const std::vector<char>& by_rays = solution.lights.exact_walls;
  if (!by_rays.empty() && by_rays[static_cast<std::size_t>(wall)] != 0) return;
  power.emitted += radiance * solution.half_range[face.at()] * area;
  power.emitted_exact += radiance * half_range(problem.space()) * entering_part(behind) * area;
}

/// Adds one cell to the powers of its region; `fluence_mean` is the integral until all cells are in.
void add_cell_power(RegionPower& power, const Problem& problem, const Solution& solution, CellIndex cell,
                    std::size_t band) {
  const int b = static_cast<int>(band);
  const std::size_t bands = problem.bands().names.size();
  const double volume = problem.mesh().volume(cell);
  const double fluence = ConstCellField(solution.fluence, bands).mean(cell, band) * volume;
  power.volume += volume;
  power.fluence_mean += fluence;
  power.absorbed += solution.absorbed.empty() ? problem.absorption(cell, b) * fluence
                                              : ConstBandTable(solution.absorbed, bands)(cell, band) * volume;
  power.emitted += full_range(problem.space()) * problem.emission(cell, b) * volume;
}

}  // namespace

std::vector<std::vector<WallPower>> wall_powers(const Problem& problem, const Solution& solution) {
  const TetrahedralMesh& mesh = problem.mesh();
  const std::size_t bands = problem.bands().names.size();
  std::vector<std::vector<WallPower>> powers(problem.walls().size(), std::vector<WallPower>(bands));
  for (int face = 0; face < mesh.boundary_face_count(); ++face)
    for (std::size_t band = 0; band < bands; ++band)
      add_face(powers[static_cast<std::size_t>(mesh.wall(FaceIndex(face)))][band], problem, solution,
               FaceIndex(face), band);
  for (std::size_t w = 0; w < solution.lights.from_walls.size(); ++w)
    for (std::size_t band = 0; band < bands; ++band) {
      powers[w][band].emitted += solution.lights.from_walls[w][band];
      powers[w][band].emitted_exact += solution.lights.from_walls[w][band];
    }
  for (std::size_t w = 0; w < solution.by_direction.walls.size(); ++w)
    for (std::size_t band = 0; band < bands; ++band) {
      powers[w][band].emitted += solution.by_direction.walls[w][band];
      powers[w][band].emitted_exact += solution.by_direction.walls[w][band];
    }
  for (std::vector<WallPower>& wall : powers)
    for (WallPower& power : wall) power.irradiance_mean = ratio(power.incoming, power.area);
  return powers;
}

std::vector<std::vector<RegionPower>> region_powers(const Problem& problem, const Solution& solution) {
  const TetrahedralMesh& mesh = problem.mesh();
  const std::size_t bands = problem.bands().names.size();
  std::vector<std::vector<RegionPower>> powers(problem.media().size(), std::vector<RegionPower>(bands));
  for (int c = 0; c < mesh.cell_count(); ++c)
    for (std::size_t band = 0; band < bands; ++band)
      add_cell_power(powers[static_cast<std::size_t>(mesh.region(CellIndex(c)))][band], problem, solution,
                     CellIndex(c), band);
  for (std::size_t r = 0; r < solution.by_direction.regions.size(); ++r)
    for (std::size_t band = 0; band < bands; ++band)
      powers[r][band].emitted += solution.by_direction.regions[r][band];
  for (std::vector<RegionPower>& region : powers)
    for (RegionPower& power : region) power.fluence_mean = ratio(power.fluence_mean, power.volume);
  return powers;
}

std::vector<Balance> balances(const Problem& problem, const Solution& solution) {
  std::vector<Balance> balances(problem.bands().names.size());
  const auto regions = region_powers(problem, solution);
  const auto walls = wall_powers(problem, solution);
  for (std::size_t band = 0; band < balances.size(); ++band) {
    Balance& balance = balances[band];
    for (const auto& region : regions) {
      balance.emitted += region[band].emitted;
      balance.absorbed += region[band].absorbed;
    }
    for (const auto& wall : walls) {
      const double reflected = wall[band].outgoing - wall[band].emitted;
      balance.inflow += wall[band].emitted;
      balance.outflow += wall[band].incoming - reflected;
    }
    if (!solution.lights.inside.empty()) balance.inflow += solution.lights.inside[band];
    const double given = balance.emitted + balance.inflow;
    balance.residual = ratio(given - balance.absorbed - balance.outflow, given);
  }
  return balances;
}

}  // namespace etendue
