// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/result/heat_rows.h"

#include <cmath>

#include "app/write/result/temperature_fields.h"
#include "mesh/tetrahedra/corners.h"
#include "solver/solution/node_means.h"

namespace etendue {
namespace {

/// Power that a wall absorbs. The outgoing power of one side of a sheet includes the power transmitted from
/// the other side.
double absorbed_by(const Wall& wall, std::size_t band, const WallPower& power) {
  if (wall.transmitted(band) > 0) return wall.absorptivity(band) * power.incoming;
  return power.incoming - power.outgoing + power.emitted;
}

/// [wall] mean temperature over the area, by the faces' vertices; 0 where the case gives none.
std::vector<double> mean_wall_temperatures(const RunResult& result) {
  const std::vector<double> temperatures = vertex_temperatures_of_walls(result);
  const TetrahedralMesh& mesh = result.problem.mesh();
  std::vector<double> sums(result.walls.size(), 0), areas(result.walls.size(), 0);
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    const auto wall = static_cast<std::size_t>(mesh.wall(face));
    areas[wall] += mesh.area(face);
    for (std::size_t i = 0; i < 3; ++i) sums[wall] += mesh.area(face) / 3 * temperatures[3 * face.at() + i];
  }
  for (std::size_t wall = 0; wall < sums.size(); ++wall)
    if (areas[wall] > 0) sums[wall] /= areas[wall];
  return sums;
}

HeatRow wall_row(const RunResult& result, std::size_t wall, double temperature) {
  const Wall& behind = result.problem.walls()[wall];
  HeatRow row{.is_wall = true, .name = behind.name, .temperature = temperature};
  double variance = 0;
  for (std::size_t band = 0; band < result.walls[wall].size(); ++band) {
    const WallPower& power = result.walls[wall][band];
    row.extent = power.area;
    row.emitted += power.emitted;
    row.absorbed += absorbed_by(behind, band, power);
    const double reradiated = behind.reradiation.empty() ? 0 : behind.reradiation[band] * power.incoming;
    row.emitted += reradiated;
    row.absorbed += reradiated;
    if (result.errors) variance += std::pow(result.errors->net[wall][band], 2);
  }
  if (result.heat) row.conducted = result.heat->conducted[wall];
  if (result.heat) row.convected = result.heat->convected[wall];
  row.net = row.absorbed - row.emitted;
  row.error = std::sqrt(variance);
  return row;
}

/// What the cells of a region add up to.
struct CellSums {
  double temperature = 0;  ///< times volume [K m^3]
  double reradiated = 0;   ///< what is absorbed and sent out again [W]
};

/// [region]
std::vector<CellSums> sums_of_cells(const RunResult& result) {
  const Problem& problem = result.problem;
  const TetrahedralMesh& mesh = problem.mesh();
  const std::vector<double> temperatures = cell_temperatures(result);
  const std::vector<double> fluence =
      node_means(result.solution.fluence, 4, static_cast<std::size_t>(problem.band_count()));
  std::vector<CellSums> sums(problem.media().size());
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    CellSums& region = sums[static_cast<std::size_t>(mesh.region(cell))];
    region.temperature += mesh.volume(cell) * temperatures[cell.at()];
    // A medium that reradiates has one band.
    if (const Medium& medium = problem.medium(mesh.region(cell)); !medium.reradiation.empty())
      region.reradiated += medium.reradiation.front().cell_mean(corners_of(mesh, cell)) * fluence[cell.at()] *
                           mesh.volume(cell);
  }
  return sums;
}

HeatRow region_row(const RunResult& result, std::size_t region, const CellSums& cells) {
  HeatRow row{
      .name = result.problem.media()[region].name, .emitted = cells.reradiated, .absorbed = cells.reradiated};
  double variance = 0;
  for (std::size_t band = 0; band < result.regions[region].size(); ++band) {
    const RegionPower& power = result.regions[region][band];
    row.extent = power.volume;
    row.emitted += power.emitted;
    row.absorbed += power.absorbed;
    if (result.errors) variance += std::pow(result.errors->regions[region][band].absorbed, 2);
  }
  row.net = row.emitted - row.absorbed;
  row.error = std::sqrt(variance);
  if (row.extent > 0) row.temperature = cells.temperature / row.extent;
  return row;
}

}  // namespace

std::vector<HeatRow> heat_rows(const RunResult& result) {
  std::vector<HeatRow> rows;
  const std::vector<double> temperatures = mean_wall_temperatures(result);
  for (std::size_t wall = 0; wall < result.walls.size(); ++wall)
    rows.push_back(wall_row(result, wall, temperatures[wall]));
  const std::vector<CellSums> cells = sums_of_cells(result);
  for (std::size_t region = 0; region < result.regions.size(); ++region)
    rows.push_back(region_row(result, region, cells[region]));
  return rows;
}

}  // namespace etendue
