// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/adjacency/mesh_edges.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace etendue {
namespace {

std::pair<std::int32_t, std::int32_t> ends(const MeshEdges::Edge& edge) { return {edge.first, edge.second}; }

}  // namespace

void MeshEdges::add(std::int32_t a, std::int32_t b, CellIndex cell) {
  edges_.push_back({std::min(a, b), std::max(a, b), cell});
}

// Stable: of equal ones the first cell stays.
void MeshEdges::sort() {
  std::ranges::stable_sort(edges_, {}, ends);
  const auto are_equal = [](const Edge& a, const Edge& b) { return ends(a) == ends(b); };
  edges_.erase(std::unique(edges_.begin(), edges_.end(), are_equal), edges_.end());
  edges_.shrink_to_fit();
}

std::size_t MeshEdges::between(std::int32_t a, std::int32_t b) const {
  const std::pair<std::int32_t, std::int32_t> wanted = std::minmax(a, b);
  const auto found = std::ranges::lower_bound(edges_, wanted, {}, ends);
  assert(found != edges_.end() && ends(*found) == wanted);
  return static_cast<std::size_t>(found - edges_.begin());
}

}  // namespace etendue
