// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "solver/lights/cell_light.h"

namespace etendue {

/// The light of a source with an extent at the vertices of the mesh, shared by the cells around them. What is
/// linear in a cell is the logarithm of the transmittance T = phi/phi_clear, where phi_clear is the fluence
/// in empty space, which needs no rays.
class VertexLight {
 public:
  VertexLight(const LightPaths& paths, const LightSource& source, int threads);

  /// Adds the light of a cell. False, and nothing is added, where that will not do: near the light, and in
  /// the dark and its edge.
  bool add(const LitCell& cell, LightBeams& beams, NodalMoments& moments) const;
  /// The same for the irradiance of a boundary face; mirrors are left out too.
  bool add(FaceIndex face, LightBeams& beams, NodalMoments& moments) const;

 private:
  struct LightHere {
    double fluence = 0;
    Vec3 direction = Vec3::Zero();  ///< net flux over fluence
  };
  bool is_lit(std::span<const std::int32_t> vertices) const;
  /// [band] at a point of a cell or face with these vertices.
  std::vector<LightHere> look(const PointInCell& here, std::span<const double> barycentric,
                              std::span<const std::int32_t> vertices, LightBeams& beams) const;
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
