// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/result/heat_rows.h"

#include <cmath>

#include "app/write/result/temperature_fields.h"
#include "mesh/tetrahedra/corners.h"

namespace etendue {
namespace {

/// Power that a wall absorbs. The outgoing power of one side of a sheet includes the power transmitted from
/// the other side.
double absorbed_by(const Wall& wall, std::size_t band, const WallPower& power) {
  if (wall.transmitted(band) > 0)
    return (1 - wall.mean_reflectance(band) - wall.transmitted(band)) * power.incoming;
  return power.incoming - power.outgoing + power.emitted;
}

/// Mean temperature of a wall over its area, by its faces' vertices.
double mean_temperature(const RunResult& result, std::size_t wall) {
  const WallTemperature temperature(result, static_cast<int>(wall));
  const TetrahedralMesh& mesh = result.problem.mesh();
  const auto bands = static_cast<std::size_t>(result.problem.band_count());
  double sum = 0, area = 0;
  for (std::int32_t f = 0; f < mesh.boundary_face_count() && temperature.known(); ++f) {
    const FaceIndex face(f);
    if (mesh.wall(face) != static_cast<int>(wall)) continue;
    area += mesh.area(face);
    for (std::size_t i = 0; i < 3; ++i)
      sum +=
          mesh.area(face) / 3 *
          temperature.at(corner_of(mesh, face, i), result.solution.irradiance[(3 * face.at() + i) * bands]);
  }
  return area > 0 ? sum / area : 0;
}

HeatRow wall_row(const RunResult& result, std::size_t wall) {
  const Wall& behind = result.problem.walls()[wall];
  HeatRow row{.is_wall = true, .name = behind.name, .temperature = mean_temperature(result, wall)};
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
  row.net = row.absorbed - row.emitted;
  row.error = std::sqrt(variance);
  return row;
}

/// Adds to a region's row its mean temperature and what it absorbs and sends out again [W].
void add_cells(const RunResult& result, std::size_t region, const std::vector<double>& temperatures,
               HeatRow& row) {
  const TetrahedralMesh& mesh = result.problem.mesh();
  const Medium& medium = result.problem.media()[region];
  double volume = 0;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    if (mesh.region(cell) != static_cast<int>(region)) continue;
    volume += mesh.volume(cell);
    row.temperature += mesh.volume(cell) * temperatures[cell.at()];
    if (medium.reradiation.empty()) continue;
    // One gray band.
    double fluence = 0;
    for (std::size_t i = 0; i < 4; ++i) fluence += result.solution.fluence[4 * cell.at() + i] / 4;
    const double reradiated =
        medium.reradiation.front().cell_mean(corners_of(mesh, cell)) * fluence * mesh.volume(cell);
    row.emitted += reradiated;
    row.absorbed += reradiated;
  }
  if (volume > 0) row.temperature /= volume;
}

HeatRow region_row(const RunResult& result, std::size_t region, const std::vector<double>& temperatures) {
  HeatRow row{.name = result.problem.media()[region].name};
  add_cells(result, region, temperatures, row);
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
  return row;
}

}  // namespace

std::vector<HeatRow> heat_rows(const RunResult& result) {
  std::vector<HeatRow> rows;
  for (std::size_t wall = 0; wall < result.walls.size(); ++wall) rows.push_back(wall_row(result, wall));
  const std::vector<double> temperatures = cell_temperatures(result);
  for (std::size_t region = 0; region < result.regions.size(); ++region)
    rows.push_back(region_row(result, region, temperatures));
  return rows;
}

}  // namespace etendue
