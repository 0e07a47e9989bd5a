// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

namespace etendue {

/// A dependence: light passes from one cell to another.
struct FlowEdge {
  std::int32_t from = 0;
  std::int32_t to = 0;
  double weight = 0;  ///< |a_f|, the area of the face seen along the direction
  std::int32_t face = 0;
};

/// Strongly connected components (Tarjan 1972) of a graph on `nodes` nodes: [node] number of its component.
std::vector<std::int32_t> strong_components(std::int32_t nodes, const std::vector<FlowEdge>& edges);

/// Faces whose dependences must be given up so that no cycle is left: within each strong component, the edges
/// that point backwards in the sequence of Eades, Lin and Smyth (1993), which keeps their weight small.
/// Sorted by face.
std::vector<std::int32_t> feedback_faces(std::int32_t nodes, const std::vector<FlowEdge>& edges);

}  // namespace etendue
