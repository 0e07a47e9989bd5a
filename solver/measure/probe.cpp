// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/measure/probe.h"

#include <cstddef>

namespace etendue {
namespace {

/// Adds the P1 field of one cell at a point, times a factor.
void add_cell(std::vector<ProbeValue>& values, const Solution& solution, const CellPoint& point,
              double factor) {
  const std::size_t bands = values.size();
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t node = point.cell.at() * 4 + i;
    const double weight = factor * point.barycentric[i];
    for (std::size_t band = 0; band < bands; ++band) {
      values[band].fluence += weight * solution.fluence[node * bands + band];
      for (std::size_t axis = 0; axis < 3; ++axis)
        values[band].net_flux[axis] += weight * solution.net_flux[(node * 3 + axis) * bands + band];
    }
  }
}

}  // namespace

std::vector<ProbeValue> probe(const Problem& problem, const Solution& solution, const CellLocator& locator,
                              const Vec3& point) {
  const std::vector<CellPoint> cells = locator.find(point);
  if (cells.empty()) return {};
  double volume = 0;
  for (const CellPoint& cell : cells) volume += problem.mesh().volume(cell.cell);
  std::vector<ProbeValue> values(problem.bands().names.size());
  for (const CellPoint& cell : cells)
    add_cell(values, solution, cell, problem.mesh().volume(cell.cell) / volume);
  return values;
}

}  // namespace etendue
