// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <map>
#include <span>
#include <utility>
#include <vector>

#include "solver/lights/cell_light.h"

namespace etendue {

/// The light of a source with an extent at the vertices of the mesh, shared by the cells around them. What is
/// linear in a cell is the logarithm of the transmittance T = phi/phi_clear, where phi_clear is the fluence
/// in empty space, which needs no rays.
class VertexLight {
 public:
  VertexLight(const LightPaths& paths, const LightSource& source, int threads);

  /// Adds the light of a cell. False, and nothing is added, where that will not do: near a surface that
  /// shines, in thick cells near or in a volume that does, and in the dark and its edge. Near and in a volume
  /// that shines the middle of the cell is looked at too.
  bool add(const LitCell& cell, LightBeams& beams, NodalMoments& moments) const;
  /// The same for the irradiance of a boundary face.
  bool add(FaceIndex face, LightBeams& beams, NodalMoments& moments) const;

 private:
  struct LightHere {
    double fluence = 0;
    Vec3 direction = Vec3::Zero();  ///< net flux over fluence
  };
  /// By how much the middle of a cell differs from what is linear, [band].
  struct Bulge {
    std::vector<double> log_transmittance;
    std::vector<Vec3> direction;
  };
  void look_at_middle(const LitCell& cell, LightBeams& beams, Bulge& bulge) const;
  bool is_lit(std::span<const std::int32_t> vertices) const;
  bool is_too_near(const Vec3& place, double size, double thickness) const;
  void add_to_mirror(FaceIndex face, LightBeams& beams, NodalMoments& moments) const;
  /// ln T [band] at a point of a cell or face with these vertices.
  double log_transmittance(std::span<const double> barycentric, std::span<const std::int32_t> vertices,
                           std::size_t band) const;
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
  /// Of (vertex, plane of a mirror) [band]: mean |cosine| to the plane's normal, weighted by fluence.
  std::map<std::pair<std::int32_t, int>, std::vector<double>> mean_cosine_;
};

}  // namespace etendue
