// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cmath>

#include "solver/uncollided/rays/attenuation.h"
#include "solver/uncollided/rays/light_beams.h"

namespace etendue {

/// Transmittance and mean path length of a beam through a homogeneous medium.
struct HomogeneousPath {
  double transmittance;
  double mean;  ///< path length of the transmitted light [length]
};

inline HomogeneousPath homogeneous_path(const BeamWay& way, double extinction) {
  const double before = std::exp(-extinction * way.distance);
  if (way.length == 0) return {before, way.distance};
  const AttenuatedWay inside = attenuated_way(extinction, way.length);
  return {before * inside.constant / way.length, way.distance + inside.linear / inside.constant};
}

}  // namespace etendue
