// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "solver/heat/blackbodies.h"
#include "solver/heat/temperature_space.h"
#include "solver/heat/wall_heat.h"
#include "solver/problem/following_sources.h"
#include "solver/problem/problem.h"
#include "solver/solution/following_emission.h"

namespace etendue {

/// A face of a cell that conducts on a wall that has a temperature. The heat that flows into it is
/// conductance (T - T_w) - k dT/dn, and weak enough to vanish with k whatever the cells (Nitsche 1971).
struct HeldFace {
  CellIndex cell;
  std::size_t wall;
  std::array<std::size_t, 3> corners;    ///< of the cell, on the face
  std::array<std::int32_t, 3> unknowns;  ///< of the wall there; -1: its temperature is given
  std::array<double, 3> temperature;     ///< that is given there [K]
  double area;                           ///< [m^2]
  double conductance;                    ///< [W/(m^2 K)]
  std::array<double, 4> normal_flow;     ///< [corner of the cell] k d(lambda)/dn out of the cell [W/(m^2 K)]
};

/// Sum of the absorption coefficients of a cell [1/m].
double absorption_of_all_bands(const Problem& problem, CellIndex cell);

/// The heat of media and walls on linear elements whose mass is lumped: what a vertex of a cell absorbs and
/// emits is that of a quarter of the cell, so that sums over unknowns are exactly those of the transport
/// equation.
class HeatBalance {
 public:
  /// The arguments must outlive it. Throws InputError where a heat source is negative or not finite.
  HeatBalance(const Problem& problem, const HeatProblem& heat, const TemperatureSpace& space);

  Blackbodies blackbodies(std::span<const double> temperature) const;
  /// What is emitted: absorption, or emissivity, times the radiance of a blackbody at each vertex.
  FollowingSources sources(const Blackbodies& blackbodies) const;
  /// [unknown] Heat that it gains from its source, light, convection and conduction [W].
  std::vector<double> gains(std::span<const double> temperature, const Blackbodies& blackbodies,
                            const LightAtVertices& light) const;
  /// [unknown] A quarter of the volume of the cells around it, of a wall of the cell beside it [m^3].
  const std::vector<double>& volumes() const { return volumes_; }
  const WallHeat& walls() const { return walls_; }
  const std::vector<HeldFace>& held_faces() const { return held_; }
  /// [wall] Heat conducted into it [W].
  std::vector<double> conducted(std::span<const double> temperature) const;

 private:
  CellEmission emission(const Blackbodies& blackbodies) const;
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
  WallHeat walls_;
};

}  // namespace etendue
