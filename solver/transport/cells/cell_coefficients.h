// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>

#include "solver/solution/added_extinction.h"
#include "solver/solution/solve_options.h"
#include "solver/transport/kernel/sweep_kernel.h"
#include "solver/transport/state/aligned_array.h"

namespace etendue {

/// Extinction times size above which Lumping::automatic lumps the mass of a cell: thicker ones oscillate with
/// the consistent mass where light enters; equation (8) of docs/theory/theory.md.
inline constexpr double lumping_thickness = 2;

/// Coefficients of the cell equations (5) of docs/theory/theory.md that do not depend on the direction.
class CellCoefficients {
 public:
  /// `extinction` is [cell][band] [1/length], the real part of `added` in it; the imaginary part of complex
  /// radiances is that of `added`. Which cells are lumped does not
  /// depend on what is added: the solution is an analytic function of it. The mesh must outlive it.
  CellCoefficients(const TetrahedralMesh& mesh, std::span<const double> extinction,
                   const AddedExtinction& added, int bands, Basis basis, Lumping lumping,
                   Scalar scalar = Scalar::double_precision);

  Basis basis() const { return basis_; }
  int bands() const { return bands_; }
  int stride() const { return stride_; }
  int nodes() const { return nodes_per_cell(basis_); }
  int face_nodes() const { return nodes_per_face(basis_); }
  /// Numbers of one cell's, and of one face's, nodal values.
  std::size_t cell_length() const {
    return static_cast<std::size_t>(nodes()) * static_cast<std::size_t>(stride_);
  }
  std::size_t trace_length() const {
    return static_cast<std::size_t>(face_nodes()) * static_cast<std::size_t>(stride_);
  }
  RecordLayout layout() const { return record_layout(basis_, stride_, scalar_); }
  /// The records that sweeps read, [cell + 1][layout().length], with no source yet. The last is the idle
  /// cell's. All of a record is divided by one factor (see scale()), which changes no radiance.
  template <class Real>
  AlignedArrayOf<Real> make_records() const;

  /// Factors (sum, own) of the right-hand side of a source s in one cell and band:
  /// right_i = sum (s_0 + s_1 + s_2 + s_3) + own s_i.
  struct SourceFactors {
    double sum = 0;
    double own = 0;
  };
  SourceFactors source_factors(CellIndex cell, int band) const;
  /// Factors of a source whose integrals with the basis functions are kept, whatever the mass of the cell.
  SourceFactors projected_source_factors(CellIndex cell) const;
  /// Divisor of the normals, the mass and the source of a cell: 1 in double precision; in single
  /// precision, where products of four areas could leave the range of numbers, a power of two near the area
  /// of the largest face.
  double scale(CellIndex cell) const { return scales_.empty() ? 1 : scales_[cell.at()]; }
  bool is_lumped(CellIndex cell, int band) const;
  /// Whether two neighbouring bands are the real and the imaginary part of one radiance.
  bool is_complex() const { return !imaginary_.empty(); }
  /// As the record holds it (cell_record.h).
  double mass(CellIndex cell, int band) const;
  /// The same for an extinction that depends on the ordinate. Lumping and source factors stay those of the
  /// mean ordinate, and imaginary parts are the same for all ordinates.
  double mass(CellIndex cell, int band, double extinction) const;
  /// Pairs of a cell and a band whose mass is lumped.
  long lumped_count() const;

 private:
  double imaginary_of(std::size_t cell, std::size_t band) const {
    return imaginary_[(cell * static_cast<std::size_t>(bands_) + band) / 2];
  }

  Basis basis_;
  int bands_;
  int stride_;
  Scalar scalar_;
  const TetrahedralMesh& mesh_;
  std::span<const double> volumes_;
  std::vector<double> extinction_;  ///< [cell][band] [1/length]
  std::vector<double> imaginary_;   ///< [cell][band / 2] [1/length]; empty: not complex
  std::vector<char> lumped_;        ///< [cell][band]
  std::vector<double> scales_;      ///< [cell]; empty: 1
};

/// Edge of the regular tetrahedron of this volume: the size of a cell in "extinction times cell size".
double cell_size(double volume);

}  // namespace etendue
