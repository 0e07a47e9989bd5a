// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/heat/temperature_space.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/blackbody.h"
#include "solver/heat/cell_conductivity.h"
#include "solver/problem/band_blackbody.h"

namespace etendue {
namespace {

constexpr int most_steps = 50;
constexpr double rounding = 1e-15;

/// Corners of cells at the same vertex that are joined through faces between cells of a kind.
class JoinedCorners {
 public:
  template <class IsOfKind>
  JoinedCorners(const TetrahedralMesh& mesh, const IsOfKind& is_of_kind)
      : before_(static_cast<std::size_t>(4 * mesh.cell_count())) {
    std::iota(before_.begin(), before_.end(), std::size_t{0});
    for (std::int32_t f = mesh.boundary_face_count(); f < mesh.face_count(); ++f) {
      const CellIndex one = mesh.owner(FaceIndex(f)), other = mesh.neighbour(FaceIndex(f));
      if (!is_of_kind(one) || !is_of_kind(other)) continue;
      for (const std::int32_t vertex : mesh.vertices(FaceIndex(f)))
        join(corner_at(mesh, one, vertex), corner_at(mesh, other, vertex));
    }
  }

  /// One corner for all that are joined.
  std::size_t first_of(CellIndex cell, std::size_t i) { return first_of(4 * cell.at() + i); }

 private:
  static std::size_t corner_at(const TetrahedralMesh& mesh, CellIndex cell, std::int32_t vertex) {
    const auto& vertices = mesh.vertices(cell);
    return 4 * cell.at() + static_cast<std::size_t>(std::ranges::find(vertices, vertex) - vertices.begin());
  }

  std::size_t first_of(std::size_t corner) {
    while (before_[corner] != corner) corner = before_[corner] = before_[before_[corner]];
    return corner;
  }

  void join(std::size_t one, std::size_t other) {
    const std::size_t low = std::min(first_of(one), first_of(other));
    const std::size_t high = std::max(first_of(one), first_of(other));
    before_[high] = low;
  }

  std::vector<std::size_t> before_;  ///< a joined corner, or itself
};

/// Part of the blackbody's power of all bands that a wall emits at a temperature.
double emissivity(const Problem& problem, int wall, double kelvin) {
  double sum = 0;
  for (int band = 0; band < problem.band_count(); ++band)
    sum += problem.wall(wall).absorptivity(static_cast<std::size_t>(band)) *
           band_blackbody(problem.bands(), band, kelvin);
  return sum * std::numbers::pi / (stefan_boltzmann * std::pow(kelvin, 4));
}

}  // namespace

TemperatureSpace::TemperatureSpace(const Problem& problem, const HeatProblem& heat)
    : conductivity_(static_cast<std::size_t>(problem.mesh().cell_count()), 0),
      conducts_(conductivity_.size(), 0),
      unknowns_(4 * conductivity_.size(), -1),
      of_walls_(static_cast<std::size_t>(3 * problem.mesh().boundary_face_count()), -1),
      usual_(heat.start),
      stored_(heat.changes_in_time ? std::pow(heat.start, 3) : 0) {
  const TetrahedralMesh& mesh = problem.mesh();
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
    if (const auto& medium = heat.media[static_cast<std::size_t>(mesh.region(CellIndex(c)))]) {
      conductivity_[CellIndex(c).at()] =
          cell_conductivity(*medium, mesh, CellIndex(c), {usual_, usual_, usual_, usual_});
      conducts_[CellIndex(c).at()] =
          conductivity_[CellIndex(c).at()] > 0 || medium->conductivity.depends_on_temperature() ? 1 : 0;
    }
  number_vertices(mesh);
  number_walls(problem, heat);
  unknowns_before_cells_ = size_;
  number_cells(mesh, heat);
}

void TemperatureSpace::number_vertices(const TetrahedralMesh& mesh) {
  JoinedCorners corners(mesh, [&](CellIndex cell) { return conducts(cell); });
  std::vector<std::int32_t> of_corner(unknowns_.size(), -1);
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
    for (std::size_t i = 0; i < 4 && conducts(CellIndex(c)); ++i) {
      std::int32_t& unknown = of_corner[corners.first_of(CellIndex(c), i)];
      if (unknown < 0) unknown = static_cast<std::int32_t>(size_++);
      unknowns_[4 * CellIndex(c).at() + i] = unknown;
    }
  vertex_unknowns_ = size_;
}

void TemperatureSpace::number_walls(const Problem& problem, const HeatProblem& heat) {
  const TetrahedralMesh& mesh = problem.mesh();
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    const auto& wall = heat.walls[static_cast<std::size_t>(mesh.wall(face))];
    if (!wall) continue;
    const CellIndex cell = mesh.owner(face);
    const double height = 3 * mesh.volume(cell) / mesh.area(face);
    const Loss loss{stefan_boltzmann * emissivity(problem, mesh.wall(face), usual_),
                    wall->heat_transfer_coefficient + conductivity(cell) / height};
    for (std::size_t i = 0; i < 3; ++i) {
      of_walls_[3 * face.at() + i] = static_cast<std::int32_t>(size_++);
      losses_.push_back(loss);
    }
  }
}

void TemperatureSpace::number_cells(const TetrahedralMesh& mesh, const HeatProblem& heat) {
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    if (!heat.media[static_cast<std::size_t>(mesh.region(cell))] || conducts(cell)) continue;
    for (std::size_t i = 0; i < 4; ++i) unknowns_[4 * cell.at() + i] = static_cast<std::int32_t>(size_++);
  }
}

TemperatureSpace::Loss TemperatureSpace::loss(std::size_t unknown) const {
  if (is_temperature(unknown)) return {0, 1};
  if (unknown >= unknowns_before_cells_) return {1, stored_};
  return losses_[unknown - vertex_unknowns_];
}

double TemperatureSpace::value(std::size_t unknown, double kelvin) const {
  const auto [radiation, linear] = loss(unknown);
  return (radiation * std::abs(std::pow(kelvin, 3)) + linear) * kelvin /
         (radiation * std::pow(usual_, 3) + linear);
}

double TemperatureSpace::power_per_value(std::size_t unknown, double kelvin) const {
  const auto [radiation, linear] = loss(unknown);
  const double usual = std::pow(usual_, 3), cube = std::abs(std::pow(kelvin, 3));
  if (linear == 0) return usual;
  return 4 * cube * (radiation * usual + linear) / (4 * radiation * cube + linear);
}

double TemperatureSpace::kelvin_per_value(std::size_t unknown, double kelvin) const {
  const auto [radiation, linear] = loss(unknown);
  const double usual = std::pow(usual_, 3), cube = std::abs(std::pow(kelvin, 3));
  return (radiation * usual + linear) / (4 * radiation * cube + linear);
}

/// By Newton's method from above: the loss is convex.
double TemperatureSpace::temperature(std::size_t unknown, double value) const {
  const auto [radiation, linear] = loss(unknown);
  const double given = std::abs(value) * (radiation * std::pow(usual_, 3) + linear);
  if (given == 0) return 0;
  double kelvin = radiation > 0 ? std::pow(given / radiation, 0.25) : given / linear;
  if (linear > 0) kelvin = std::min(kelvin, given / linear);
  for (int i = 0; radiation > 0 && linear > 0 && i < most_steps; ++i) {
    const double cube = kelvin * kelvin * kelvin;
    const double change =
        (radiation * cube * kelvin + linear * kelvin - given) / (4 * radiation * cube + linear);
    kelvin -= change;
    if (std::abs(change) <= rounding * kelvin) break;
  }
  return std::copysign(kelvin, value);
}

std::vector<double> TemperatureSpace::temperatures(std::span<const double> values) const {
  std::vector<double> kelvin(values.begin(), values.end());
  for (std::size_t i = vertex_unknowns_; i < kelvin.size(); ++i) kelvin[i] = temperature(i, values[i]);
  return kelvin;
}

}  // namespace etendue
