// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/geometry/surface_files/open_surfaces.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "base/position.h"

namespace etendue {
namespace {

using Edges = std::map<std::array<int, 2>, std::vector<int>>;  ///< polygons at each edge

/// Points with equal coordinates have the number of the first of them.
std::vector<int> first_of_equal(const std::vector<Vec3>& points) {
  std::map<std::array<double, 3>, int> numbers;
  std::vector<int> first;
  for (const Vec3& p : points)
    first.push_back(numbers.try_emplace({p.x(), p.y(), p.z()}, static_cast<int>(first.size())).first->second);
  return first;
}

Edges polygons_on_edges(const PolygonSoup& soup) {
  const std::vector<int> first = first_of_equal(soup.points);
  Edges edges;
  for (std::size_t p = 0; p < soup.polygons.size(); ++p) {
    const std::vector<int>& polygon = soup.polygons[p];
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const int a = first[position(polygon[i])], b = first[position(polygon[(i + 1) % polygon.size()])];
      if (a != b) edges[{std::min(a, b), std::max(a, b)}].push_back(static_cast<int>(p));
    }
  }
  return edges;
}

/// Numbers that are joined one after the other; each has the number of its piece.
class Pieces {
 public:
  explicit Pieces(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
  int piece(int i) {
    while (parent_[position(i)] != i) i = parent_[position(i)] = parent_[position(parent_[position(i)])];
    return i;
  }
  void join(int a, int b) { parent_[position(piece(a))] = piece(b); }

 private:
  std::vector<int> parent_;
};

void add_polygon(const PolygonSoup& soup, std::size_t polygon, PolygonSoup& part) {
  part.polygons.push_back(soup.polygons[polygon]);
  part.walls.push_back(soup.walls[polygon]);
}

}  // namespace

SoupParts parts_of(const PolygonSoup& soup) {
  const Edges edges = polygons_on_edges(soup);
  if (std::ranges::any_of(edges, [](const auto& edge) { return edge.second.size() > 2; })) return {soup, {}};
  Pieces pieces(soup.polygons.size());
  for (const auto& [edge, polygons] : edges)
    if (polygons.size() == 2) pieces.join(polygons[0], polygons[1]);
  std::vector<bool> is_open(soup.polygons.size(), false);
  for (const auto& [edge, polygons] : edges)
    if (polygons.size() == 1) is_open[position(pieces.piece(polygons[0]))] = true;
  SoupParts parts;
  parts.closed.points = parts.open.points = soup.points;
  parts.closed.wall_names = parts.open.wall_names = soup.wall_names;
  for (std::size_t p = 0; p < soup.polygons.size(); ++p)
    add_polygon(soup, p, is_open[position(pieces.piece(static_cast<int>(p)))] ? parts.open : parts.closed);
  if (parts.closed.polygons.empty()) std::swap(parts.closed, parts.open);
  return parts;
}

}  // namespace etendue
