// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "solver/heat/blackbodies.h"
#include "solver/heat/conduction.h"
#include "solver/heat/temperature_space.h"
#include "solver/heat/wall_heat.h"
#include "solver/problem/following_sources.h"
#include "solver/problem/problem.h"
#include "solver/solution/following_emission.h"

namespace etendue {

/// Sum of the absorption coefficients of a cell [1/m].
double absorption_of_all_bands(const Problem& problem, CellIndex cell);

/// The heat of media and walls on linear elements whose mass is lumped: what a vertex of a cell absorbs and
/// emits is that of a quarter of the cell, so that sums over unknowns are exactly those of the transport
/// equation.
class HeatBalance {
 public:
  /// The arguments must outlive it. Throws InputError where a heat source is negative or not finite.
  HeatBalance(const Problem& problem, const HeatProblem& heat, const TemperatureSpace& space);

  /// Finds the conductivities at these temperatures [unknown]. Throws InputError where one is negative or not
  /// finite.
  void set_temperature(std::span<const double> temperature) { conduction_.set_temperature(temperature); }
  /// Gives heat sources and heat fluxes the factors that they have at a time [s].
  void set_time(double t);
  Blackbodies blackbodies(std::span<const double> temperature) const;
  /// What is emitted: absorption, or emissivity, times the radiance of a blackbody at each vertex.
  FollowingSources sources(const Blackbodies& blackbodies) const;
  /// [unknown] Heat that it gains from its source, light, convection and conduction [W].
  std::vector<double> gains(std::span<const double> temperature, const Blackbodies& blackbodies,
                            const LightAtVertices& light) const;
  /// [unknown] A quarter of the volume of the cells around it, of a wall of the cell beside it [m^3].
  const std::vector<double>& volumes() const { return volumes_; }
  const WallHeat& walls() const { return walls_; }
  const Conduction& conduction() const { return conduction_; }

 private:
  CellEmission emission(const Blackbodies& blackbodies) const;
  void find_sources();

  const Problem& problem_;
  const HeatProblem& heat_;
  const TemperatureSpace& space_;
  std::vector<double> volumes_;
  std::vector<double> sources_;  ///< [cell][4], without their factors in time [W/m^3]
  std::vector<double> factors_;  ///< [region] of the sources
  Conduction conduction_;
  WallHeat walls_;
};

}  // namespace etendue
