// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/cells/cell_coefficients.h"

#include <algorithm>
#include <cmath>

namespace etendue {
namespace {

/// Outward area normals of faces 0, 1 and 2.
template <class Real>
void write_normals(const TetrahedralMesh& mesh, CellIndex cell, double scale, Real* record) {
  for (std::size_t f = 0; f < 3; ++f) {
    const FaceIndex face(mesh.faces(cell)[f]);
    // One normal for both sides of a face: the outflow of one cell is the inflow of the other, to the last
    // bits.
    const double side = (mesh.owner(face) == cell ? 1 : -1) / scale;
    for (std::size_t axis = 0; axis < 3; ++axis)
      record[3 * axis + f] =
          static_cast<Real>(side * mesh.area_normal(face)[static_cast<Eigen::Index>(axis)]);
  }
}

/// The power of two below the area of the largest face.
double size_of_faces(const TetrahedralMesh& mesh, CellIndex cell) {
  double largest = 0;
  for (const std::int32_t face : mesh.faces(cell)) largest = std::max(largest, mesh.area(FaceIndex(face)));
  return std::exp2(std::floor(std::log2(largest)));
}

bool lumps(Lumping lumping, double thickness) {
  return lumping == Lumping::mass || (lumping == Lumping::automatic && thickness > lumping_thickness);
}

}  // namespace

double cell_size(double volume) { return std::cbrt(6 * std::sqrt(2.0) * volume); }

CellCoefficients::CellCoefficients(const TetrahedralMesh& mesh, std::span<const double> extinction,
                                   const AddedExtinction& added, int bands, Basis basis, Lumping lumping,
                                   Scalar scalar)
    : basis_(basis),
      bands_(bands),
      stride_(lane_stride(bands)),
      scalar_(scalar),
      mesh_(mesh),
      volumes_(mesh.volumes()),
      extinction_(extinction.begin(), extinction.end()),
      imaginary_(added.imaginary),
      lumped_(extinction.size(), 0) {
  if (scalar == Scalar::single_precision)
    for (std::int32_t c = 0; c < mesh.cell_count(); ++c) scales_.push_back(size_of_faces(mesh, CellIndex(c)));
  if (basis == Basis::constant) return;
  for (std::size_t c = 0; c < volumes_.size(); ++c)
    for (std::size_t b = 0; b < static_cast<std::size_t>(bands); ++b) {
      const std::size_t at = c * static_cast<std::size_t>(bands) + b;
      const double steady = extinction_[at] - added.real_at(at);
      lumped_[at] = lumps(lumping, steady * cell_size(volumes_[c])) ? 1 : 0;
    }
}

double CellCoefficients::mass(CellIndex cell, int band) const {
  const std::size_t at = cell.at() * static_cast<std::size_t>(bands_) + static_cast<std::size_t>(band);
  return mass(cell, band, extinction_[at]);
}

double CellCoefficients::mass(CellIndex cell, int band, double extinction) const {
  const bool is_imaginary = is_complex() && band % 2 == 1;
  const double removed =
      (is_imaginary ? imaginary_of(cell.at(), static_cast<std::size_t>(band)) : extinction) *
      volumes_[cell.at()] / scale(cell);
  if (basis_ == Basis::constant) return removed;
  return is_lumped(cell, band) ? -3 * removed : 0.6 * removed;
}

template <class Real>
AlignedArrayOf<Real> CellCoefficients::make_records() const {
  const RecordLayout record = layout();
  AlignedArrayOf<Real> records((volumes_.size() + 1) * record.length);
  for (std::int32_t c = 0; c < mesh_.cell_count(); ++c) {
    Real* own = records.data() + static_cast<std::size_t>(c) * record.length;
    write_normals(mesh_, CellIndex(c), scale(CellIndex(c)), own);
    for (int b = 0; b < bands_; ++b)
      own[record.mass + static_cast<std::size_t>(b)] = static_cast<Real>(mass(CellIndex(c), b));
  }
  Real* idle = records.data() + volumes_.size() * record.length;
  for (int b = 0; b < stride_; ++b) idle[record.mass + static_cast<std::size_t>(b)] = 1;
  return records;
}

template AlignedArrayOf<double> CellCoefficients::make_records() const;
template AlignedArrayOf<float> CellCoefficients::make_records() const;

bool CellCoefficients::is_lumped(CellIndex cell, int band) const {
  return lumped_[cell.at() * static_cast<std::size_t>(bands_) + static_cast<std::size_t>(band)] != 0;
}

long CellCoefficients::lumped_count() const { return std::count(lumped_.begin(), lumped_.end(), 1); }

CellCoefficients::SourceFactors CellCoefficients::source_factors(CellIndex cell, int band) const {
  if (basis_ == Basis::linear && is_lumped(cell, band)) return {0, 3 * volumes_[cell.at()] / scale(cell)};
  return projected_source_factors(cell);
}

CellCoefficients::SourceFactors CellCoefficients::projected_source_factors(CellIndex cell) const {
  const double volume = volumes_[cell.at()] / scale(cell);
  if (basis_ == Basis::constant) return {0, volume};
  return {0.6 * volume, 0.6 * volume};
}

}  // namespace etendue
