// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/lights/cell_light.h"

namespace etendue {

/// The light of a source with an extent at the vertices of the mesh, shared by the cells around them. What is
/// linear in a cell is the logarithm of the transmittance T = phi/phi_clear, where phi_clear is the fluence
/// in empty space, which needs no rays.
class VertexLight {
 public:
  VertexLight(const LightPaths& paths, const LightSource& source, int threads);

  /// Adds the light of a cell. False, and nothing is added, where that will not do: near the light, in the
  /// edge of a shadow, where the transmittance changes a lot.
  bool add(const LitCell& cell, LightBeams& beams, NodalMoments& moments) const;

 private:
  std::size_t at(std::int32_t vertex, std::size_t band) const {
    return static_cast<std::size_t>(vertex) * bands_ + band;
  }

  const LightPaths& paths_;
  const LightSource& source_;
  std::size_t bands_;
  std::vector<double> log_transmittance_;  ///< [vertex][band]; -infinity in the dark
  std::vector<Vec3> mean_direction_;       ///< [vertex][band] net flux over fluence
};

}  // namespace etendue
