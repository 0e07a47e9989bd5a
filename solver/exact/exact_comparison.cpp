// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/exact/exact_comparison.h"

#include <array>
#include <tuple>

#include "base/field_view.h"
#include "base/quadrature/cell_rule.h"
#include "mesh/tetrahedra/corners.h"
#include "solver/solution/error_norms.h"

namespace etendue {
namespace {

constexpr std::size_t rule_size = 14;

/// The exact fluence wherever it is compared.
struct FluenceSamples {
  std::vector<double> in_cells;     ///< [cell][point of the rule]
  std::vector<double> at_vertices;  ///< [vertex]
};

FluenceSamples sample(const TetrahedralMesh& mesh, const ExactRadiance& radiance, const DirectionSet& set) {
  FluenceSamples samples;
  samples.in_cells.resize(static_cast<std::size_t>(mesh.cell_count()) * rule_size);
  samples.at_vertices.resize(static_cast<std::size_t>(mesh.vertex_count()));
#pragma omp parallel for schedule(static)
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
    for (std::size_t i = 0; i < rule_size; ++i)
      samples.in_cells[static_cast<std::size_t>(c) * rule_size + i] =
          exact_fluence(radiance, set, point_at(cell_rule()[i].barycentric, corners_of(mesh, CellIndex(c))));
#pragma omp parallel for schedule(static)
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v)
    samples.at_vertices[static_cast<std::size_t>(v)] =
        exact_fluence(radiance, set, mesh.point(VertexIndex(v)));
  return samples;
}

/// Error of the field, and of its means over the cells.
FluenceError fluence_error(const TetrahedralMesh& mesh, const Solution& solution,
                           const FluenceSamples& samples, std::size_t band, std::size_t bands) {
  const ConstCellField fluence(solution.fluence, bands);
  ErrorNorms norms, means;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    double mean = 0, exact_mean = 0;
    for (std::size_t i = 0; i < rule_size; ++i) {
      const double exact = samples.in_cells[cell.at() * rule_size + i], weight = cell_rule()[i].weight;
      double value = 0;
      for (std::size_t j = 0; j < 4; ++j) value += cell_rule()[i].barycentric[j] * fluence(cell, j, band);
      norms.add(value, exact, weight * mesh.volume(cell));
      mean += weight * value;
      exact_mean += weight * exact;
    }
    means.add(mean, exact_mean, mesh.volume(cell));
    for (std::size_t j = 0; j < 4; ++j)
      norms.add(fluence(cell, j, band), samples.at_vertices[VertexIndex(mesh.vertices(cell)[j]).at()], 0);
  }
  return {norms.l2(), norms.maximum(), means.l2()};
}

std::vector<std::vector<double>> absorbed_powers(const Problem& problem, const FluenceSamples& samples) {
  const TetrahedralMesh& mesh = problem.mesh();
  const int bands = problem.band_count();
  std::vector<std::vector<double>> powers(problem.media().size(),
                                          std::vector<double>(static_cast<std::size_t>(bands), 0));
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    double mean = 0;
    for (std::size_t i = 0; i < rule_size; ++i)
      mean += cell_rule()[i].weight * samples.in_cells[cell.at() * rule_size + i];
    for (int band = 0; band < bands; ++band)
      powers[static_cast<std::size_t>(mesh.region(cell))][static_cast<std::size_t>(band)] +=
          problem.absorption(cell, band) * mesh.volume(cell) * mean;
  }
  return powers;
}

/// Six points in a triangle, exact to degree 4 (Dunavant 1985): barycentric coordinates (a, a, 1 - 2a).
struct FaceRulePoint {
  std::array<double, 3> barycentric;
  double weight;
};
std::array<FaceRulePoint, 6> make_face_rule() {
  std::array<FaceRulePoint, 6> rule;
  for (std::size_t i = 0; i < 3; ++i)
    for (const auto& [a, weight, at] : {std::tuple(0.445948490915965, 0.223381589678011, i),
                                        std::tuple(0.091576213509771, 0.109951743655322, i + 3)}) {
      rule[at] = {{a, a, a}, weight};
      rule[at].barycentric[i] = 1 - 2 * a;
    }
  return rule;
}

/// Light that arrives at a face: the integral over it of the sum of w (w.n) u over w.n > 0.
double incoming_power(const TetrahedralMesh& mesh, FaceIndex face, const ExactRadiance& radiance,
                      const DirectionSet& set) {
  static const std::array<FaceRulePoint, 6> rule = make_face_rule();
  double power = 0;
  for (const FaceRulePoint& node : rule) {
    Vec3 point = Vec3::Zero();
    for (std::size_t i = 0; i < 3; ++i) point += node.barycentric[i] * corner_of(mesh, face, i);
    for (std::int32_t m = 0; m < set.count(); ++m) {
      const Vec3& direction = set.direction(OrdinateIndex(m));
      const double seen = direction.dot(mesh.area_normal(face));
      if (seen > 0)
        power += node.weight * set.weight(OrdinateIndex(m)) * seen * radiance.at(point, direction);
    }
  }
  return power;
}

}  // namespace

double exact_fluence(const ExactRadiance& radiance, const DirectionSet& set, const Vec3& point) {
  double sum = 0;
  for (std::int32_t m = 0; m < set.count(); ++m)
    sum += set.weight(OrdinateIndex(m)) * radiance.at(point, set.direction(OrdinateIndex(m)));
  return sum;
}

ExactComparison compare_with_exact(const Problem& problem, const Solution& solution,
                                   const ExactRadiance& radiance, const DirectionSet& set) {
  const TetrahedralMesh& mesh = problem.mesh();
  const auto bands = static_cast<std::size_t>(problem.band_count());
  const FluenceSamples samples = sample(mesh, radiance, set);
  ExactComparison comparison;
  for (std::size_t band = 0; band < bands; ++band)
    comparison.fluence.push_back(fluence_error(mesh, solution, samples, band, bands));
  comparison.absorbed = absorbed_powers(problem, samples);
  comparison.incoming.assign(problem.walls().size(), 0);
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
    comparison.incoming[static_cast<std::size_t>(mesh.wall(FaceIndex(f)))] +=
        incoming_power(mesh, FaceIndex(f), radiance, set);
  return comparison;
}

}  // namespace etendue
