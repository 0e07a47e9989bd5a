// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/angular/media/directional_absorption.h"

#include <fmt/format.h>

#include <cmath>

#include "base/quadrature/cell_rule.h"
#include "base/text/vector_text.h"
#include "mesh/tetrahedra/corners.h"
#include "solver/problem/problem_checks.h"

namespace etendue {
namespace {

// Rounding residual of a difference that is zero, relative to the extinction.
constexpr double rounding = 1e-9;

double mean(const AngularFormula& formula, const std::array<Vec3, 4>& cell, const Vec3& direction) {
  double sum = 0;
  for (const CellRulePoint& node : cell_rule())
    sum += node.weight * formula.at(point_at(node.barycentric, cell), direction);
  return sum;
}

[[noreturn]] void refuse(const Medium& medium, const Bands& bands, int band, double value, double scattered,
                         const Vec3& point, const Vec3& direction) {
  const std::string where =
      fmt::format("in the cell around {} in the direction {} (band {})", vector_text(point),
                  vector_text(direction), bands.names[static_cast<std::size_t>(band)]);
  if (medium.extinction_by_direction && std::isfinite(value))
    throw InputError(fault_at(
        origin_of(medium, "extinction"), fmt::format("{:.6g}", value + scattered),
        fmt::format("less than the {:.6g} that the kernel scatters, {}; give more extinction, or absorption "
                    "in its place",
                    scattered, where)));
  throw InputError(fault_at(origin_of(medium, "absorption"), fmt::format("{:.6g}", value),
                            fmt::format("{} {}; must be a finite number of at least 0 in every direction",
                                        std::isfinite(value) ? "negative" : "not a finite number", where)));
}

}  // namespace

std::vector<double> directional_absorption(const Problem& problem, const DirectionSet& directions,
                                           const Medium& medium, int band, const DenseKernel& kernel,
                                           std::span<const CellIndex> cells,
                                           std::span<const double> amplitude) {
  const TetrahedralMesh& mesh = problem.mesh();
  std::vector<double> table(static_cast<std::size_t>(directions.count()) * cells.size());
  const auto count = static_cast<std::int64_t>(cells.size());
#pragma omp parallel
  {
    const AngularFormula formula = *medium.absorption_by_direction[static_cast<std::size_t>(band)];
#pragma omp for schedule(static)
    for (std::int64_t c = 0; c < count; ++c) {
      const auto at = static_cast<std::size_t>(c);
      const std::array<Vec3, 4> cell = corners_of(mesh, cells[at]);
      for (std::size_t m = 0; m < directions.directions().size(); ++m)
        table[m * cells.size() + at] = mean(formula, cell, directions.directions()[m]);
    }
  }
  for (std::size_t m = 0; m < directions.directions().size(); ++m)
    for (std::size_t c = 0; c < cells.size(); ++c) {
      double& value = table[m * cells.size() + c];
      const double given = value;
      const double scattered = medium.extinction_by_direction ? amplitude[c] * kernel.total[m] : 0;
      value -= scattered;
      if (std::abs(value) <= rounding * given) value = 0;
      if (!(value >= 0 && std::isfinite(value)))
        refuse(medium, problem.bands(), band, value, scattered,
               point_at({0.25, 0.25, 0.25, 0.25}, corners_of(mesh, cells[c])), directions.directions()[m]);
    }
  return table;
}

}  // namespace etendue
