// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/parallel/rank_group.h"
#include "mesh/tetrahedra/adjacency/mesh_edges.h"
#include "solver/uncollided/visibility/path_attenuation.h"

namespace etendue {

/// Attenuation interpolated between the corners of a cell or a face: linear, and quadratic where its edges
/// are sampled too.
template <std::size_t corners>
struct InterpolatedAttenuation {
  std::array<std::vector<PathAttenuation>, corners> corner;  ///< [band]
  /// [edge][band] Difference of the middles of the edges 01, 02, ... from the mean of their ends; empty where
  /// it is zero.
  std::array<std::vector<PathAttenuation>, corners*(corners - 1) / 2> edge;

  PathAttenuation at(const std::array<double, corners>& barycentric, std::size_t band) const;
};

/// Result of an interpolation in a simplex: the attenuation varies too steeply, as behind the edge of a
/// cloud, or a part of the light is hidden from a part of the simplex.
enum class Interpolation { possible, steep, unseen };

/// Attenuation of the light of an extended source at the vertices of a mesh and, where it varies, at the
/// middles of its edges: shared by the cells and faces around them.
class VertexAttenuation {
 public:
  /// `ranks` are processes that share the rays; null: this one alone.
  VertexAttenuation(const LightPaths& paths, const ExtendedSource& source, int threads,
                    RankGroup* ranks = nullptr);

  /// Gets the attenuation between these vertices, unless a part of the light is hidden.
  template <std::size_t corners>
  Interpolation take(const std::array<std::int32_t, corners>& vertices,
                     InterpolatedAttenuation<corners>& interpolated) const;

 private:
  void sample_vertices(const LightPaths& paths, int threads, RankGroup* ranks);
  void sample_edges(const LightPaths& paths, int threads, RankGroup* ranks);
  bool are_even() const;

  const ExtendedSource& source_;
  std::size_t bands_;
  std::vector<PathAttenuation> at_vertices_;  ///< [vertex][band]
  std::vector<Visibility> vertex_visibility_;
  MeshEdges edges_;  ///< between vertices that see all; none in a homogeneous medium
  std::vector<PathAttenuation>
      at_edges_;  ///< [edge][band] difference of the middle from the mean of the ends
  std::vector<Visibility> edge_visibility_;  ///< [edge]
  std::vector<char> steep_;                  ///< [edge]
};

}  // namespace etendue
