// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "solver/angular/harmonics/harmonics.h"
#include "solver/angular/sets/direction_set.h"
#include "solver/problem/problem.h"
#include "solver/transport/cells/cell_coefficients.h"
#include "solver/transport/scattering/moment_orbits.h"
#include "solver/transport/scattering/scattering_plan.h"
#include "solver/transport/state/transport_state.h"

namespace etendue {

/// Scattering through moments of the radiance, equation (11) of docs/theory/theory.md,
///
///     S(w_m) = sigma_s / (4 pi) sum over k of chi_l(k) Y_k(w_m) phi_k,   phi_k = sum of w_n Y_k(w_n) u_n,
///
/// with harmonics orthonormalized on the direction set, equation (12): energy and asymmetry are exact on
/// every set. Only the cells whose medium scatters anisotropically (and those with a meter or that scatter by
/// a matrix) are "angular": they have a source for each direction and moments beyond the fluence. Rows of
/// directions begin with a scratch row 0.
class ScatteringMoments {
 public:
  /// `observed` are cells whose radiance is wanted direction by direction. Where the plan says delta-M the
  /// part of the light that goes straight ahead is left out. The arguments must outlive it.
  ScatteringMoments(const Problem& problem, const DirectionSet& directions, const CellCoefficients& cells,
                    const std::vector<ScatteringTreatment>& plan, const OrdinateSchedule& schedule,
                    std::span<const CellIndex> observed);

  std::size_t row_count() const { return angular_cells_.size(); }  ///< without the scratch row
  std::size_t row_length() const { return row_length_; }           ///< numbers
  int moment_count() const { return harmonics_.count(); }
  std::size_t moments_size() const {
    return row_count() * static_cast<std::size_t>(moment_count()) * row_length_;
  }
  /// [cell + 1] row, 0 without, as the idle cell; null where no cell is angular.
  const std::int32_t* index() const { return angular_cells_.empty() ? nullptr : index_.data(); }
  std::int32_t row(CellIndex cell) const { return index_[cell.at()]; }
  std::span<const std::int32_t> angular_cells() const { return angular_cells_; }
  const MomentOrbits& orbits() const { return orbits_; }
  int degree_of(int moment) const { return harmonics_.degree_of(moment); }
  /// chi of a moment in a region and band: what scatters into it is sigma_s chi phi_k over the full range.
  double phase_moment(int region, int moment, int band) const {
    const auto at = static_cast<std::size_t>(region) * count() + static_cast<std::size_t>(moment);
    return phase_moments_[at * static_cast<std::size_t>(cells_.stride()) + static_cast<std::size_t>(band)];
  }

  /// Right-hand sides of emission and scattering of a state, for cells first … last - 1: the isotropic part
  /// into the source of the cells' records, and moments [row][moment][node][stride] for angular cells.
  template <class Real>
  void form_source(const TransportState& state, Emission emission, std::int32_t first, std::int32_t last,
                   Real* records, Real* moments) const;

  /// Right-hand sides of an isotropic source of 1 in all cells and bands, as form_source() writes them.
  template <class Real>
  void form_unit_source(Real* records, Real* moments) const;

 private:
  std::size_t count() const { return static_cast<std::size_t>(moment_count()); }
  const ScatteringTreatment& treatment(int region, int band) const {
    return plan_[static_cast<std::size_t>(region * problem_.band_count() + band)];
  }
  void find_angular_cells(std::span<const CellIndex> observed);
  void fill_phase_moments();

  const Problem& problem_;
  const DirectionSet& directions_;
  const CellCoefficients& cells_;
  const std::vector<ScatteringTreatment>& plan_;
  DiscreteHarmonics harmonics_;
  MomentOrbits orbits_;
  std::size_t row_length_;
  std::vector<std::int32_t> index_;
  std::vector<std::int32_t> angular_cells_;
  std::vector<double> phase_moments_;  ///< [region][moment][stride]
};

}  // namespace etendue
