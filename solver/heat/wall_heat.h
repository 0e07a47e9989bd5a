// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "solver/heat/blackbodies.h"
#include "solver/heat/temperature_space.h"
#include "solver/problem/problem.h"
#include "solver/solution/following_emission.h"

namespace etendue {

/// A boundary face whose temperature follows.
struct FollowingFace {
  FaceIndex face;
  std::size_t wall;
  std::array<std::size_t, 3> unknowns;  ///< at its vertices
};

/// The heat of walls whose temperature follows, at the vertices of each face, of whose area each has a third:
/// what one absorbs and emits is exactly that of the transport equation.
class WallHeat {
 public:
  /// The arguments must outlive it.
  WallHeat(const Problem& problem, const HeatProblem& heat, const TemperatureSpace& space);

  const std::vector<FollowingFace>& faces() const { return faces_; }
  /// Gives heat fluxes the factors that they have at a time [s].
  void set_time(double t);
  /// [boundary face][3][band] What the walls send; empty: no temperature follows.
  std::vector<double> radiance(const Blackbodies& blackbodies) const;
  /// Adds the heat that unknowns gain by light, convection and the heat flux that is given [W].
  void add_gains(std::span<const double> temperature, const Blackbodies& blackbodies,
                 const LightAtVertices& light, std::vector<double>& gains) const;
  /// Change of what is emitted at a vertex with the value of its unknown [W/(m^2 K)].
  double emission_slope(const FollowingFace& face, std::size_t i, const Blackbodies& blackbodies) const;
  /// Change of the heat that convection carries away with the temperature [W/(m^2 K)].
  double convection_slope(const FollowingFace& face) const {
    return heat_.walls[face.wall]->heat_transfer_coefficient;
  }
  /// [wall] Heat that convection carries away [W].
  std::vector<double> convected(std::span<const double> temperature) const;

 private:
  double emissivity(const FollowingFace& face, std::size_t band) const {
    return problem_.walls()[face.wall].absorptivity(band);
  }

  const Problem& problem_;
  const HeatProblem& heat_;
  std::vector<double> factors_;  ///< [wall] of heat fluxes
  std::vector<FollowingFace> faces_;
};

}  // namespace etendue
