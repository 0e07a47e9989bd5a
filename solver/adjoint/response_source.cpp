// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/adjoint/response_source.h"

#include <algorithm>

namespace etendue {

ResponseSource::ResponseSource(const Problem& problem, const DirectionSet& directions,
                               const Response& response)
    : problem_(problem), directions_(directions), response_(response) {
  if (const auto* point = std::get_if<PointFluence>(&response)) add_point(point->cells, 1);
  if (const auto* mean = std::get_if<MeanIrradiance>(&response))
    for (const auto& cells : mean->points) add_point(cells, 1 / static_cast<double>(mean->points.size()));
}

// Of the mass matrix V/20 (1 + delta_ij) of a cell the inverse is 20/V (delta_ij - 1/5).
void ResponseSource::add_point(const std::vector<CellPoint>& cells, double weight) {
  double volume = 0;
  for (const CellPoint& point : cells) volume += problem_.mesh().volume(point.cell);
  for (const CellPoint& point : cells)
    for (std::size_t i = 0; i < 4; ++i)
      points_[point.cell.value()][i] += weight * 20 / volume * (point.barycentric[i] - 0.2);
}

bool ResponseSource::depends_on_direction(CellIndex cell) const {
  return std::holds_alternative<MeanIrradiance>(response_) && points_.contains(cell.value());
}

void ResponseSource::add_projected_source(OrdinateIndex m, CellIndex cell, std::span<double> values) const {
  const auto bands = static_cast<std::size_t>(problem_.band_count());
  if (const auto* region = std::get_if<AbsorbedPower>(&response_)) {
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t b = 0; b < bands; ++b)
        values[i * bands + b] += absorbed_share(problem_, *region, cell, static_cast<int>(b));
    return;
  }
  const auto found = points_.find(cell.value());
  if (found == points_.end()) return;
  // Irradiance comes against its normal, so its importance leaves along it.
  const auto* mean = std::get_if<MeanIrradiance>(&response_);
  const double seen = mean == nullptr ? 1 : std::max(0.0, directions_.direction(m).dot(mean->normal));
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t b = 0; b < bands; ++b) values[i * bands + b] += seen * found->second[i];
}

void ResponseSource::add_inflow(OrdinateIndex, FaceIndex face, std::span<double> values) const {
  const auto* at = std::get_if<ArrivingPower>(&response_);
  if (at == nullptr || problem_.mesh().wall(face) != at->wall) return;
  for (double& value : values) value += 1;
}

}  // namespace etendue
