// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/heat/temperature_space.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/errors.h"
#include "mesh/tetrahedra/corners.h"

namespace etendue {
namespace {

double conductivity_in(const HeatMedium& medium, const TetrahedralMesh& mesh, CellIndex cell) {
  const CellSample sample = medium.conductivity.sample(corners_of(mesh, cell));
  if (std::isfinite(sample.mean) && sample.smallest >= 0) return sample.mean;
  throw InputError(
      fault_at(medium.origin, "conductivity",
               fmt::format("is {:g} at ({:.6g}, {:.6g}, {:.6g}); use at least 0", sample.smallest,
                           sample.where.x(), sample.where.y(), sample.where.z())));
}

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

}  // namespace

TemperatureSpace::TemperatureSpace(const TetrahedralMesh& mesh, const HeatProblem& heat)
    : conductivity_(static_cast<std::size_t>(mesh.cell_count()), 0),
      unknowns_(4 * conductivity_.size(), -1),
      usual_(heat.start) {
  const auto medium = [&](CellIndex cell) -> const std::optional<HeatMedium>& {
    return heat.media[static_cast<std::size_t>(mesh.region(cell))];
  };
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
    if (const CellIndex cell(c); medium(cell))
      conductivity_[cell.at()] = conductivity_in(*medium(cell), mesh, cell);
  JoinedCorners corners(mesh, [&](CellIndex cell) { return conducts(cell); });
  std::vector<std::int32_t> of_corner(unknowns_.size(), -1);
  std::int32_t count = 0;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
    for (std::size_t i = 0; i < 4 && conducts(CellIndex(c)); ++i) {
      std::int32_t& unknown = of_corner[corners.first_of(CellIndex(c), i)];
      if (unknown < 0) unknown = count++;
      unknowns_[4 * CellIndex(c).at() + i] = unknown;
    }
  vertex_unknowns_ = static_cast<std::size_t>(count);
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    if (!medium(cell) || conducts(cell)) continue;
    for (std::size_t i = 0; i < 4; ++i) unknowns_[4 * cell.at() + i] = count++;
  }
  size_ = static_cast<std::size_t>(count);
}

std::vector<double> TemperatureSpace::temperatures(std::span<const double> values) const {
  std::vector<double> kelvin(values.begin(), values.end());
  for (std::size_t i = vertex_unknowns_; i < kelvin.size(); ++i)
    kelvin[i] = std::copysign(std::pow(std::abs(values[i]) * std::pow(usual_, 3), 0.25), values[i]);
  return kelvin;
}

}  // namespace etendue
