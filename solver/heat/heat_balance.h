// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "solver/heat/temperature_space.h"
#include "solver/problem/cell_emission.h"
#include "solver/problem/problem.h"

namespace etendue {

/// Radiances of blackbodies and their derivatives by the unknown, [unknown][band]. Below a temperature of
/// zero radiances are those above it, and negative.
struct Blackbodies {
  std::vector<double> radiance;  ///< [W/(m^2 sr)]
  std::vector<double> slope;     ///< [W/(m^2 sr K)]
};

/// A face of a cell that conducts on a wall that holds a temperature. The heat that flows into it is
/// conductance (T - held) - k dT/dn, and weak enough to vanish with k whatever the cells (Nitsche 1971).
struct HeldFace {
  CellIndex cell;
  std::size_t wall;
  std::array<std::size_t, 3> corners;  ///< of the cell, on the face
  std::array<double, 3> temperature;   ///< held there [K]
  double area;                         ///< [m^2]
  double conductance;                  ///< [W/(m^2 K)]
  std::array<double, 4> normal_flow;   ///< [corner of the cell] k d(lambda)/dn out of the cell [W/(m^2 K)]
};

/// Sum of the absorption coefficients of a cell [1/m].
double absorption_of_all_bands(const Problem& problem, CellIndex cell);

/// The heat of media on linear elements whose mass is lumped: what a vertex of a cell absorbs and emits is
/// that of a quarter of the cell, so that sums over unknowns are exactly those of the transport equation.
class HeatBalance {
 public:
  /// The arguments must outlive it. Throws InputError where a heat source is negative or not finite.
  HeatBalance(const Problem& problem, const HeatProblem& heat, const TemperatureSpace& space);

  Blackbodies blackbodies(std::span<const double> temperature) const;
  /// Emission of the media, absorption times the radiance of a blackbody at each vertex.
  CellEmission emission(const Blackbodies& blackbodies) const;
  /// [unknown] Heat that it gains from its source, light, and conduction [W]. `fluence` is [cell][4][band].
  std::vector<double> gains(std::span<const double> temperature, const Blackbodies& blackbodies,
                            std::span<const double> fluence) const;
  /// [unknown] A quarter of the volume of the cells around it [m^3].
  const std::vector<double>& volumes() const { return volumes_; }
  const std::vector<HeldFace>& held_faces() const { return held_; }
  /// [wall] Heat conducted into it [W].
  std::vector<double> conducted(std::span<const double> temperature) const;

 private:
  void find_held();
  void find_sources();
  struct WallFlow {
    std::array<double, 3> at = {};
    double mean_difference = 0;
  };
  WallFlow flow_into(const HeldFace& held, std::span<const double> temperature) const;
  void add_held(const HeldFace& held, std::span<const double> temperature, std::vector<double>& gains) const;
  void add_conduction(CellIndex cell, std::span<const double> temperature, std::vector<double>& gains) const;

  const Problem& problem_;
  const HeatProblem& heat_;
  const TemperatureSpace& space_;
  std::vector<double> volumes_;
  std::vector<double> sources_;  ///< [cell][4] [W/m^3]
  std::vector<HeldFace> held_;
};

}  // namespace etendue
