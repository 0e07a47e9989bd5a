// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/base/vec3.h"

namespace etendue {

/// Light at a point as it would arrive in empty space, [band].
struct ClearLight {
  explicit ClearLight(std::size_t bands) : fluence(bands), flux(bands), way(bands) { clear(); }

  void clear() {
    fluence.assign(fluence.size(), 0);
    flux.assign(flux.size(), Vec3::Zero());
    way.assign(way.size(), 0);
  }

  std::vector<double> fluence;  ///< [power/length^2]
  std::vector<Vec3> flux;       ///< [power/length^2]
  std::vector<double> way;      ///< mean length of the way of the fluence
};

}  // namespace etendue
