// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/angular/media/linear_coefficients.h"

#include <algorithm>
#include <array>

#include "base/quadrature/cell_rule.h"
#include "mesh/tetrahedra/corners.h"

namespace etendue {
namespace {

bool varies_in(const Medium& medium, std::size_t band) {
  const auto b = static_cast<int>(band);
  const bool kernel = medium.is_directional(b) &&
                      !std::holds_alternative<LeafCanopy>(medium.directional[band]) &&
                      !std::holds_alternative<MicroFlakes>(medium.directional[band]);
  if (kernel || medium.absorbs_by_direction(b)) return false;
  return !medium.absorption[band].is_constant() || !medium.scattering[band].is_constant();
}

/// The gradient of the projection of a coefficient with this mean, times what keeps it from being negative.
/// With the moments b_i of its product with the linear functions, as parts of the volume, the projection has
/// the nodal values 4 (5 b_i - sum of b).
Vec3 slope_of(const Coefficient& coefficient, const std::array<Vec3, 4>& corners, double mean) {
  if (coefficient.is_constant()) return Vec3::Zero();
  std::array<double, 4> moments{};
  double sum = 0;
  for (const CellRulePoint& node : coefficient.rule(corners)) {
    const double value = node.weight * coefficient.at(point_at(node.barycentric, corners));
    sum += value;
    for (std::size_t i = 0; i < 4; ++i) moments[i] += node.barycentric[i] * value;
  }
  Vec3 gradient = Vec3::Zero();
  double lowest = 0;  // below the mean
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3& a = corners[(i + 1) % 4];
    const Vec3 across = (corners[(i + 2) % 4] - a).cross(corners[(i + 3) % 4] - a);
    const double rise = 4 * (5 * moments[i] - sum) - sum;
    gradient += rise / across.dot(corners[i] - a) * across;
    lowest = std::min(lowest, rise);
  }
  return -lowest > mean ? Vec3(gradient * (mean / -lowest)) : gradient;
}

}  // namespace

LinearCoefficients::LinearCoefficients(const Problem& problem)
    : bands_(static_cast<std::size_t>(problem.band_count())) {
  std::vector<char> varying(problem.media().size(), 0);
  for (std::size_t region = 0; region < varying.size(); ++region)
    for (std::size_t b = 0; b < bands_; ++b)
      if (varies_in(problem.media()[region], b)) varying[region] = 1;
  if (std::ranges::count(varying, 1) == 0) return;
  const TetrahedralMesh& mesh = problem.mesh();
  std::vector<CellIndex> cells;
  row_.assign(static_cast<std::size_t>(mesh.cell_count()), -1);
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    if (varying[static_cast<std::size_t>(mesh.region(CellIndex(c)))] == 0) continue;
    row_[static_cast<std::size_t>(c)] = static_cast<std::int32_t>(cells.size());
    cells.emplace_back(c);
  }
  slopes_.resize(cells.size() * bands_);
#pragma omp parallel
  {
    const std::vector<Medium> media(problem.media().begin(), problem.media().end());  // formulas of its own
#pragma omp for schedule(static)
    for (std::size_t row = 0; row < cells.size(); ++row) {
      const Medium& medium = media[static_cast<std::size_t>(mesh.region(cells[row]))];
      const std::array<Vec3, 4> corners = corners_of(mesh, cells[row]);
      for (std::size_t b = 0; b < bands_; ++b) {
        Slopes& slopes = slopes_[row * bands_ + b];
        slopes.centroid = mesh.centroid(cells[row]);
        if (!varies_in(medium, b)) continue;
        const auto band = static_cast<int>(b);
        slopes.absorption = slope_of(medium.absorption[b], corners, problem.absorption(cells[row], band));
        slopes.scattering = slope_of(medium.scattering[b], corners, problem.scattering(cells[row], band));
      }
    }
  }
}

}  // namespace etendue
