// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/heat/temperature_space.h"
#include "solver/problem/problem.h"

namespace etendue {

/// A face of a cell that conducts on a wall that has a temperature. The heat that flows into it is
/// k (penalty (T - T_w) - dT/dn), and weak enough to vanish with k whatever the cells (Nitsche 1971).
struct HeldFace {
  CellIndex cell;
  std::size_t wall;
  std::array<std::size_t, 3> corners;    ///< of the cell, on the face
  std::array<std::int32_t, 3> unknowns;  ///< of the wall there; -1: its temperature is given
  std::array<double, 3> temperature;     ///< that is given there [K]
  double area;                           ///< [m^2]
  double penalty;                        ///< [1/m]
  std::array<double, 4> normal_slope;    ///< [corner of the cell] d(lambda)/dn out of the cell [1/m]
};

/// Conduction of heat on continuous linear elements, with a conductivity for each cell.
class Conduction {
 public:
  /// The arguments must outlive it. Throws InputError where a conductivity is negative or not finite.
  Conduction(const Problem& problem, const HeatProblem& heat, const TemperatureSpace& space);

  /// Finds the conductivities at temperatures [unknown]. Throws InputError as above.
  void set_temperature(std::span<const double> temperature);
  double conductivity(CellIndex cell) const { return conductivity_[cell.at()]; }  ///< mean [W/(m K)]
  const std::vector<HeldFace>& held_faces() const { return held_; }
  /// Adds the heat that unknowns gain [W].
  void add_gains(std::span<const double> temperature, std::vector<double>& gains) const;
  /// [wall] Heat conducted into it [W].
  std::vector<double> conducted(std::span<const double> temperature) const;

 private:
  struct WallFlow {
    std::array<double, 3> at = {};
    double mean_difference = 0;
  };
  void find_held();
  void add_cell(CellIndex cell, std::span<const double> temperature, std::vector<double>& gains) const;
  WallFlow flow_into(const HeldFace& held, std::span<const double> temperature) const;
  void add_held(const HeldFace& held, std::span<const double> temperature, std::vector<double>& gains) const;

  const Problem& problem_;
  const HeatProblem& heat_;
  const TemperatureSpace& space_;
  std::vector<double> conductivity_;  ///< [cell] 0 where none
  std::vector<HeldFace> held_;
};

}  // namespace etendue
