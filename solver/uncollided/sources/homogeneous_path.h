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

inline HomogeneousPath homogeneous_path(const EmissionInterval& interval, double extinction) {
  const double before = std::exp(-extinction * interval.distance);
  if (interval.length == 0) return {before, interval.distance};
  const AttenuationIntegrals inside = attenuation_integrals(extinction, interval.length);
  return {before * inside.constant / interval.length, interval.distance + inside.linear / inside.constant};
}

}  // namespace etendue
