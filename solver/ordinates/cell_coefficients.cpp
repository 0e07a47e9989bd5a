// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/ordinates/cell_coefficients.h"

#include <algorithm>
#include <cmath>

namespace etendue {
namespace {

/// Cells thicker than this oscillate with the consistent mass where light enters (docs/theory.md).
constexpr double lumping_thickness = 2;

AlignedArray outward_normals(const TetrahedralMesh& mesh) {
  AlignedArray normals(static_cast<std::size_t>(mesh.cell_count()) * normals_stride);
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    double* record = normals.data() + static_cast<std::size_t>(c) * normals_stride;
    for (std::size_t f = 0; f < 4; ++f) {
      const FaceIndex face(mesh.faces(CellIndex(c))[f]);
      // One normal for both sides of a face: what leaves one cell enters the other, to the last bit.
      const double side = mesh.owner(face) == CellIndex(c) ? 1 : -1;
      for (int axis = 0; axis < 3; ++axis)
        record[3 * f + static_cast<std::size_t>(axis)] = side * mesh.area_normal(face)[axis];
    }
  }
  return normals;
}

bool lumps(Lumping lumping, double thickness) {
  return lumping == Lumping::mass || (lumping == Lumping::automatic && thickness > lumping_thickness);
}

}  // namespace

double cell_size(double volume) { return std::cbrt(6 * std::sqrt(2.0) * volume); }

CellCoefficients::CellCoefficients(const TetrahedralMesh& mesh, std::span<const double> extinction, int bands,
                                   Basis basis, Lumping lumping)
    : basis_(basis),
      bands_(bands),
      stride_(lane_stride(bands)),
      volumes_(mesh.volumes()),
      normals_(outward_normals(mesh)),
      mass_(static_cast<std::size_t>(mesh.cell_count()) * 2 * static_cast<std::size_t>(stride_)),
      lumped_(extinction.size(), 0) {
  const auto width = static_cast<std::size_t>(stride_);
  for (std::size_t c = 0; c < volumes_.size(); ++c)
    for (std::size_t b = 0; b < static_cast<std::size_t>(bands); ++b) {
      const std::size_t at = c * static_cast<std::size_t>(bands) + b;
      const double absorbed = extinction[at] * volumes_[c];
      double* mass = mass_.data() + c * 2 * width + b;
      if (basis == Basis::constant) {
        mass[0] = absorbed;
      } else if (lumps(lumping, extinction[at] * cell_size(volumes_[c]))) {
        lumped_[at] = 1;
        mass[0] = 3 * absorbed;
      } else {
        mass[0] = mass[width] = 0.6 * absorbed;
      }
    }
}

bool CellCoefficients::is_lumped(CellIndex cell, int band) const {
  return lumped_[cell.at() * static_cast<std::size_t>(bands_) + static_cast<std::size_t>(band)] != 0;
}

long CellCoefficients::lumped_count() const { return std::count(lumped_.begin(), lumped_.end(), 1); }

CellCoefficients::SourceFactors CellCoefficients::source_factors(CellIndex cell, int band) const {
  const double volume = volumes_[cell.at()];
  if (basis_ == Basis::constant) return {0, volume};
  if (is_lumped(cell, band)) return {0, 3 * volume};
  return {0.6 * volume, 0.6 * volume};
}

}  // namespace etendue
