// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/exact/exact_comparison.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "base/quadrature/cell_rule.h"

namespace etendue {
namespace {

constexpr std::size_t rule_size = 14;

/// The exact fluence wherever it is compared.
struct FluenceSamples {
  std::vector<double> in_cells;     ///< [cell][point of the rule]
  std::vector<double> at_vertices;  ///< [vertex]
};

std::array<Vec3, 4> corners(const TetrahedralMesh& mesh, CellIndex cell) {
  std::array<Vec3, 4> points;
  for (std::size_t i = 0; i < 4; ++i) points[i] = mesh.point(VertexIndex(mesh.vertices(cell)[i]));
  return points;
}

FluenceSamples sample(const TetrahedralMesh& mesh, const ExactRadiance& radiance, const DirectionSet& set) {
  FluenceSamples samples;
  samples.in_cells.resize(static_cast<std::size_t>(mesh.cell_count()) * rule_size);
  samples.at_vertices.resize(static_cast<std::size_t>(mesh.vertex_count()));
#pragma omp parallel for schedule(static)
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
    for (std::size_t i = 0; i < rule_size; ++i)
      samples.in_cells[static_cast<std::size_t>(c) * rule_size + i] =
          exact_fluence(radiance, set, point_at(cell_rule()[i].barycentric, corners(mesh, CellIndex(c))));
#pragma omp parallel for schedule(static)
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v)
    samples.at_vertices[static_cast<std::size_t>(v)] =
        exact_fluence(radiance, set, mesh.point(VertexIndex(v)));
  return samples;
}

/// Norms of a difference and of what it is compared with.
struct Norms {
  double square = 0, exact_square = 0, largest = 0, exact_largest = 0;

  void add_point(double value, double exact, double volume) {
    square += volume * (value - exact) * (value - exact);
    exact_square += volume * exact * exact;
    largest = std::max(largest, std::abs(value - exact));
    exact_largest = std::max(exact_largest, std::abs(exact));
  }
  FluenceError relative() const {
    return {exact_square > 0 ? std::sqrt(square / exact_square) : std::sqrt(square),
            exact_largest > 0 ? largest / exact_largest : largest};
  }
};

/// Of the field, and of its means over cells.
FluenceError fluence_error(const TetrahedralMesh& mesh, const Solution& solution,
                           const FluenceSamples& samples, std::size_t band, std::size_t bands) {
  Norms norms, means;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    const double* nodal = &solution.fluence[cell.at() * 4 * bands + band];
    double mean = 0, exact_mean = 0;
    for (std::size_t i = 0; i < rule_size; ++i) {
      const double exact = samples.in_cells[cell.at() * rule_size + i], weight = cell_rule()[i].weight;
      double value = 0;
      for (std::size_t j = 0; j < 4; ++j) value += cell_rule()[i].barycentric[j] * nodal[j * bands];
      norms.add_point(value, exact, weight * mesh.volume(cell));
      mean += weight * value;
      exact_mean += weight * exact;
    }
    means.add_point(mean, exact_mean, mesh.volume(cell));
    for (std::size_t j = 0; j < 4; ++j)
      norms.add_point(nodal[j * bands], samples.at_vertices[VertexIndex(mesh.vertices(cell)[j]).at()], 0);
  }
  FluenceError error = norms.relative();
  error.l2_of_means = means.relative().l2;
  return error;
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
    for (std::size_t i = 0; i < 3; ++i)
      point += node.barycentric[i] * mesh.point(VertexIndex(mesh.vertices(face)[i]));
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
