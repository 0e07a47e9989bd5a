// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/angular/harmonics/continuous_harmonics.h"
#include "solver/angular/media/directional_matter.h"
#include "solver/angular/sets/direction_set.h"
#include "solver/problem/phase_list.h"
#include "solver/problem/problem.h"
#include "solver/solution/saved_state.h"
#include "solver/solution/solve_options.h"
#include "solver/transport/scattering/scattering_plan.h"
#include "solver/transport/source/ordinate_lights.h"
#include "solver/uncollided/lights/light_setup.h"

namespace etendue {

/// Source of the light that directions carried: emission that is no light, and what they scatter, at any
/// direction of travel,
///
///     S(w) = q + sigma_s/(4 pi) sum over k of chi_k Y_k(w) phi_k
///
/// from the moments of a saved state; where scattering is by a matrix, from its radiance u_n,
///
///     S(w) = q + sigma_s (sum over n of w_n p(w.w_n) u_n) / (sum over n of w_n p(w.w_n)).
///
/// In the plane 4 pi becomes 2 pi. Leaves and flakes are those of DirectionalMatter. All are continuous in
/// w, and a constant radiance scatters into a constant one. No ordinate's radiance itself is evaluated.
class CollidedSource {
 public:
  /// `options` are those of the solution (elements, meters); of linear elements the state may be a
  /// quadratic_reconstruction() as well. The arguments must outlive it. Throws InputError where the state is
  /// not of this kind.
  CollidedSource(const LightSetup& lights, const DirectionSet& directions, const SolveOptions& options,
                 const SavedState& state);

  /// What depends on the direction alone.
  struct View {
    std::vector<double> harmonics;  ///< [k]
    std::vector<double> weights;  ///< [phase][ordinate] w_n p / sum of them, where scattering is by a matrix
    std::vector<DirectionalMatter::View> matter;  ///< of leaves and flakes
  };
  View view(const Vec3& travel) const;

  /// Lights that are left to the directions; their own light is not in values().
  const OrdinateLights& swept_lights() const { return swept_lights_; }
  /// [cell] the place of its moments in the state, from 1; 0 where only the fluence is known.
  std::span<const std::int32_t> rows() const { return row_; }
  /// Returns whether all directions are alike in a cell.
  bool is_isotropic(CellIndex cell) const { return row_[cell.at()] == 0 && dense_row_[cell.at()] < 0; }
  /// Extinction of light that continues where it is scattered straight ahead [1/length].
  double extinction(CellIndex cell, std::size_t band, const View& view) const {
    const int matter = matter_.of(problem_.mesh().region(cell), band);
    if (matter < 0) return extinction_[cell.at() * bands_ + band];
    return matter_.density(cell, band) * view.matter[static_cast<std::size_t>(matter)].extinction;
  }
  /// 4, or quadratic_nodes where the state is a quadratic reconstruction.
  std::size_t value_count() const { return std::max<std::size_t>(4, nodes_); }
  /// Writes the values at the vertices, and those of the quadratic part behind them, [value_count()][band]
  /// [power/(length^3 sr)].
  void values(CellIndex cell, const View& view, std::span<double> values) const;

 private:
  void find_rows(const LightSetup& lights, const SolveOptions& options);
  void take_dense_radiance(const DirectionSet& directions);
  double factor(int region, std::size_t k, std::size_t band) const {
    return factors_[(static_cast<std::size_t>(region) * count() + k) * bands_ + band];
  }
  std::size_t count() const { return static_cast<std::size_t>(harmonics_.count()); }
  double dense(std::size_t row, std::size_t node, std::size_t band, const double* weights) const;

  const LightSetup& lights_;
  const Problem& problem_;
  const DirectionSet& directions_;
  const SavedState& state_;
  std::size_t bands_;
  std::size_t nodes_;
  std::vector<ScatteringTreatment> plan_;  ///< [region][band]
  ContinuousHarmonics harmonics_;
  PhaseList phases_;
  DirectionalMatter matter_;
  OrdinateLights swept_lights_;
  std::vector<std::int32_t> row_;        ///< see rows()
  std::vector<std::int32_t> dense_row_;  ///< [cell], -1 without
  std::vector<double> factors_;          ///< [region][k][band] chi_k/(4 pi)
  std::vector<double> extinction_;       ///< [cell][band]
  std::vector<double> dense_radiance_;   ///< [dense row][node][band][ordinate]
};

}  // namespace etendue
