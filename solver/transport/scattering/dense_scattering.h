// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "solver/angular/kernels/directional_kernel.h"
#include "solver/transport/cells/cell_coefficients.h"
#include "solver/transport/kernel/sweep_kernel.h"
#include "solver/transport/scattering/scattering_plan.h"
#include "solver/transport/state/transport_state.h"

namespace etendue {

/// The matrices of the media that scatter by one. Bands of a medium that scatter alike share one.
struct DenseGroup {
  int region = 0;
  std::vector<int> bands;
  std::vector<CellIndex> cells;   ///< in which the matrix holds; empty: in all of the region
  DirectionalKernel directional;  ///< of a phase function for a scattering coefficient of 1

  const DenseKernel& kernel() const { return directional.kernel; }
  /// Factor of the matrix in a cell: sigma_s of a phase function, or a density.
  double amplitude(const Problem& problem, CellIndex cell, int band) const;
  /// Extinction of one ordinate for an amplitude of 1, forward scattering omitted: equation (S2) of
  /// docs/theory/scattering.md.
  double extinction(std::size_t ordinate) const {
    return kernel().leaving[ordinate] + (directional.absorbing.empty() ? 0 : directional.absorbing[ordinate]);
  }
};
/// Throws InputError where a kernel of a medium is refused.
std::vector<DenseGroup> dense_groups(const Problem& problem, const DirectionSet& directions,
                                     const std::vector<ScatteringTreatment>& plan);
/// The same for a subset of the bands, numbered in the order of `bands`.
std::vector<DenseGroup> of_bands(const std::vector<DenseGroup>& groups, std::span<const int> bands);

/// Extinction [cell][band] that the mean ordinate sees, without the light that scatters straight ahead, where
/// `extinction` counts that light in.
std::vector<double> effective_extinction(const Problem& problem, std::span<const double> extinction,
                                         const std::vector<ScatteringTreatment>& plan,
                                         const std::vector<DenseGroup>& groups);

/// Scattering through matrices, equation (S1) of docs/theory/scattering.md:
/// S_m = sigma_s sum over n != m of K_mn w_n u_n. Cells whose medium scatters so
/// ("dense cells", in rows) keep their angular solution from sweep to sweep.
class DenseScattering {
 public:
  /// `extinction` is [cell][band], straight-ahead scattering counted in. The arguments must outlive it.
  DenseScattering(const Problem& problem, const DirectionSet& directions, const CellCoefficients& cells,
                  std::span<const double> extinction, const std::vector<ScatteringTreatment>& plan,
                  const std::vector<DenseGroup>& groups);

  bool empty() const { return rows_.empty(); }
  /// [row] cell
  std::span<const std::int32_t> cells() const { return rows_; }
  std::size_t row_length() const { return row_length_; }
  /// Doubles of the angular solution, [ordinate][row][node][stride].
  std::size_t radiance_size() const {
    return static_cast<std::size_t>(directions_.count()) * rows_.size() * row_length_;
  }

  /// The right-hand sides of what scatters, for all ordinates, from the angular solution of a state.
  /// Adds the processor time to `seconds`.
  void form_source(const TransportState& last, MatrixProduct kernel, int threads, double& seconds);
  /// Sets these right-hand sides to zero.
  void clear_source() { source_.fill_zero(); }
  /// Adds them for one ordinate to rows [angular row][node][stride], that `index` finds by cell.
  template <class Real>
  void add_source(OrdinateIndex m, const std::int32_t* index, Real* angular) const;
  /// Copies the radiance of one ordinate from such rows to the next state.
  template <class Real>
  void keep_radiance(OrdinateIndex m, const std::int32_t* index, const Real* angular,
                     TransportState& next) const;
  /// Whether absorption depends on the ordinate somewhere.
  bool absorbs_by_direction() const;
  /// Adds what is absorbed from one ordinate, as the mean over each dense cell, to `absorbed` [cell][band]
  /// [power/length^3], where absorption depends on the ordinate.
  template <class Real>
  void add_absorbed(OrdinateIndex m, const std::int32_t* index, const Real* angular,
                    std::span<double> absorbed) const;
  /// Whether it does so in a cell and band.
  bool absorbs_by_direction(CellIndex cell, int band) const;
  /// Writes the mass of the dense cells for one ordinate into records (cell_record.h).
  template <class Real>
  void set_mass(OrdinateIndex m, Real* records) const;

 private:
  /// Where the pairs of a row and a band of one group stand.
  struct Lanes {
    std::vector<std::int32_t> rows;   ///< [pair]
    std::vector<std::int32_t> bands;  ///< [pair]
    std::vector<double> amplitude;    ///< [pair]
    AlignedArray matrix;              ///< [into][from] rate times w_from
    std::vector<double>
        absorption;  ///< [ordinate][pair] where a formula depends on the direction; else empty
  };
  /// The cells of a group, in the order of the mesh.
  std::vector<CellIndex> cells_of(const DenseGroup& group) const;
  void add_group(const DenseGroup& group);
  void add_absorption(const DenseGroup& group, Lanes& lanes);
  void product(const Lanes& lanes, std::size_t first, const TransportState& last, MatrixProduct kernel,
               double* factor, double* result);

  const Problem& problem_;
  const DirectionSet& directions_;
  const CellCoefficients& cells_;
  const std::vector<DenseGroup>& groups_;
  std::vector<std::int32_t> rows_;
  std::vector<std::int32_t> row_of_;  ///< [cell], -1 without
  std::size_t row_length_;
  std::vector<Lanes> lanes_;     ///< [group]
  std::vector<double> removed_;  ///< [row][band] extinction that all ordinates share
  AlignedArray source_;          ///< [ordinate][row][node][stride]
};

}  // namespace etendue
