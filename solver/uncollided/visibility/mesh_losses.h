// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/tetrahedra/adjacency/mesh_edges.h"
#include "solver/uncollided/visibility/way_loss.h"

namespace etendue {

/// Losses between the corners of a cell or a face: linear, and quadratic where its edges have been looked at.
template <std::size_t corners>
struct LossesBetween {
  std::array<std::vector<WayLoss>, corners> corner;  ///< [band]
  /// [edge][band] What the middles of the edges 01, 02, ... have beyond the mean of their ends; empty if
  /// nothing.
  std::array<std::vector<WayLoss>, corners*(corners - 1) / 2> edge;

  WayLoss at(const std::array<double, corners>& barycentric, std::size_t band) const;
};

/// Whether losses can be interpolated in a simplex; they vary too steeply, as behind the edge of a cloud; or
/// not all of the light is seen from all over it.
enum class Interpolation { possible, steep, unseen };

/// What light of a source with an extent meets on its way to the vertices of a mesh and, where that is not
/// the same everywhere, to the middles of its edges: shared by the cells and faces around them.
class MeshLosses {
 public:
  MeshLosses(const LightPaths& paths, const ExtendedSource& source, int threads);

  /// The losses between these vertices, unless it is unseen.
  template <std::size_t corners>
  Interpolation take(const std::array<std::int32_t, corners>& vertices, LossesBetween<corners>& losses) const;

 private:
  void look_at_vertices(const LightPaths& paths, int threads);
  void look_at_edges(const LightPaths& paths, int threads);
  bool are_even() const;

  const ExtendedSource& source_;
  std::size_t bands_;
  std::vector<WayLoss> at_vertices_;  ///< [vertex][band]
  std::vector<Seen> vertex_sees_;
  MeshEdges edges_;                ///< between vertices that see all; none in even matter
  std::vector<WayLoss> at_edges_;  ///< [edge][band] what the middle has beyond the mean of the ends
  std::vector<Seen> edge_sees_;    ///< [edge]
  std::vector<char> steep_;        ///< [edge]
};

}  // namespace etendue
