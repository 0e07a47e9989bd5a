// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/result/heat_rows.h"

#include <cmath>

namespace etendue {
namespace {

/// Power that a wall absorbs. The outgoing power of one side of a sheet includes the power transmitted from
/// the other side.
double absorbed_by(const Wall& wall, std::size_t band, const WallPower& power) {
  if (wall.transmitted(band) > 0)
    return (1 - wall.mean_reflectance(band) - wall.transmitted(band)) * power.incoming;
  return power.incoming - power.outgoing + power.emitted;
}

HeatRow wall_row(const RunResult& result, std::size_t wall) {
  const Wall& behind = result.problem.walls()[wall];
  HeatRow row{.is_wall = true, .name = behind.name};
  double variance = 0;
  for (std::size_t band = 0; band < result.walls[wall].size(); ++band) {
    const WallPower& power = result.walls[wall][band];
    row.extent = power.area;
    row.emitted += power.emitted;
    row.absorbed += absorbed_by(behind, band, power);
    if (result.errors) variance += std::pow(result.errors->net[wall][band], 2);
  }
  row.net = row.absorbed - row.emitted;
  row.error = std::sqrt(variance);
  return row;
}

HeatRow region_row(const RunResult& result, std::size_t region) {
  HeatRow row{.name = result.problem.media()[region].name};
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
  for (std::size_t region = 0; region < result.regions.size(); ++region)
    rows.push_back(region_row(result, region));
  return rows;
}

}  // namespace etendue
