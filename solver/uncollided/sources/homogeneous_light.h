// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "base/vec3.h"

namespace etendue {

/// Light at a point as it would arrive through a homogeneous medium, [band].
struct HomogeneousLight {
  explicit HomogeneousLight(std::size_t bands) : fluence(bands), flux(bands) { clear(); }

  void clear() {
    fluence.assign(fluence.size(), 0);
    flux.assign(flux.size(), Vec3::Zero());
  }

  std::vector<double> fluence;  ///< [power/length^2]
  std::vector<Vec3> flux;       ///< [power/length^2]
};

}  // namespace etendue
