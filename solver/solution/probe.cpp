// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/solution/probe.h"

#include <cstddef>

#include "base/field_view.h"

namespace etendue {
namespace {

/// A fluence and its net flux, as a solution has them.
struct Field {
  const std::vector<double>& fluence;
  const std::vector<double>& net_flux;
};

/// Adds the P1 field of one cell at a point, times a factor.
void add_cell_values(std::vector<ProbeValue>& values, const Field& field, const CellPoint& point,
                     double factor) {
  const std::size_t bands = values.size();
  const ConstCellField fluence(field.fluence, bands);
  const ConstCellVectors net_flux(field.net_flux, bands);
  for (std::size_t i = 0; i < 4; ++i) {
    const double weight = factor * point.barycentric[i];
    for (std::size_t band = 0; band < bands; ++band) {
      values[band].fluence += weight * fluence(point.cell, i, band);
      for (std::size_t axis = 0; axis < 3; ++axis)
        values[band].net_flux[axis] += weight * net_flux(point.cell, i, axis, band);
    }
  }
}

std::vector<ProbeValue> probe_field(const Problem& problem, const Field& field, const CellLocator& locator,
                                    const Vec3& point) {
  const std::vector<CellPoint> cells = locator.find(point);
  if (cells.empty()) return {};
  double volume = 0;
  for (const CellPoint& cell : cells) volume += problem.mesh().volume(cell.cell);
  std::vector<ProbeValue> values(problem.bands().names.size());
  for (const CellPoint& cell : cells)
    add_cell_values(values, field, cell, problem.mesh().volume(cell.cell) / volume);
  return values;
}

}  // namespace

std::vector<ProbeValue> probe(const Problem& problem, const Solution& solution, const CellLocator& locator,
                              const Vec3& point) {
  return probe_field(problem, {solution.fluence, solution.net_flux}, locator, point);
}

std::vector<ProbeValue> probe_uncollided(const Problem& problem, const Solution& solution,
                                         const CellLocator& locator, const Vec3& point) {
  return probe_field(problem, {solution.lights.fluence, solution.lights.net_flux}, locator, point);
}

}  // namespace etendue
