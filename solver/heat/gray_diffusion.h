// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "base/vector_sums.h"
#include "solver/heat/heat_balance.h"
#include "solver/transport/diffusion/block_matrix.h"

namespace etendue {

/// The highest of some temperatures by its magnitude, at least 1 K: of what is colder, changes are judged by
/// that.
inline double highest_temperature(std::span<const double> kelvin) {
  return std::max(largest_magnitude(kelvin), 1.0);
}

/// One cell with all bands together.
struct GrayCell {
  double absorption = 0;                ///< kappa [1/m]
  double diffusion = 0;                 ///< D [m]
  std::array<double, 4> emission = {};  ///< w at the vertices [W/(m^3 K)]
  std::vector<double> share;            ///< [band] of F
};

/// What eliminates the change t = (gain + kappa F) / (w + i) of an unknown of a medium that does not conduct.
struct EliminatedTemperature {
  double absorbing = 0;  ///< kappa times the volume of the unknown [m^2]
  double emitting = 0;   ///< w times it [W/K]
  double inertia = 0;    ///< i times it [W/K]

  double change(double gain, double light) const { return (gain + absorbing * light) / (emitting + inertia); }
  /// Of what it gains, the part that it sends out.
  double emitted_part() const { return emitting / (emitting + inertia); }
};

/// At the vertices of a cell.
using EliminatedCell = std::array<EliminatedTemperature, 4>;

/// Temperatures that bring the heat of media into balance where light diffuses and all bands are one,
///
///     i t - div(k grad t) + w t - kappa F = gain,    -div(D grad F) + kappa F = w t,
///
/// with the change t of the temperature and F of the fluence, the inertia i of a step in time, w = 4 pi sum
/// of sigma_a dI_b/dT, and bands weighted by what each sends out more by free paths (linear
/// multifrequency-gray acceleration; Morel, Larsen and Matzen 1985). Walls whose temperature follows emit
/// more by what they gain, and see the light of Marshak's condition. It is what preconditions the iteration
/// for temperatures.
class GrayDiffusion {
 public:
  /// The arguments must outlive it.
  GrayDiffusion(const Problem& problem, const TemperatureSpace& space, const HeatBalance& balance);

  /// [unknown] Changes of the unknowns [K] for gains [W] at these temperatures, where heat is stored with an
  /// inertia [W/K].
  std::vector<double> changes(std::span<const double> temperature, const Blackbodies& blackbodies,
                              std::span<const double> gains, std::span<const double> inertia) const;

 private:
  /// At the vertices of a cell; zeros where the medium conducts or has no temperature that follows.
  EliminatedCell eliminated_at(CellIndex cell, const GrayCell& gray, std::span<const double> temperature,
                               std::span<const double> inertia) const;
  double least_emission(CellIndex cell) const;
  double floor_of(const GrayCell& cell) const;  ///< absorption that it has at least [1/m]
  /// Whether a medium that does not conduct has cells of many absorption lengths.
  bool has_jumps(const std::vector<GrayCell>& cells) const;
  /// F at the corners of cells [4 cell + corner]: of the solution, whose F is continuous, and what cells of
  /// many absorption lengths have besides, by the interior penalty form of (D7).
  NodalVector light_of(const Eigen::VectorXd& solution, const std::vector<GrayCell>& cells,
                       const std::vector<EliminatedCell>& eliminated, std::span<const double> gains) const;

  const Problem& problem_;
  const TemperatureSpace& space_;
  const HeatBalance& balance_;
  double longest_path_;  ///< size of the domain [m]
};

}  // namespace etendue
