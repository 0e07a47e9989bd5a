// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/geometry/surface_files/outline.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "base/position.h"

namespace etendue {
namespace {

std::vector<std::array<int, 2>> directed_edges(const std::vector<int>& outline) {
  std::vector<std::array<int, 2>> edges;
  for (std::size_t i = 0; i < outline.size(); ++i)
    edges.push_back({outline[i], outline[(i + 1) % outline.size()]});
  return edges;
}

/// The middle of the longest stretch of the facet half-way between two of its corners' coordinates.
Vec3 inner_point(const std::vector<Vec3>& points, const SidedFacet& facet) {
  int axis = 0;
  facet.normal.cwiseAbs().maxCoeff(&axis);
  const int b = (axis + 1) % 3, c = (axis + 2) % 3;
  std::vector<double> levels;
  for (const auto& edge : facet.edges) levels.push_back(points[position(edge[0])][b]);
  std::sort(levels.begin(), levels.end());
  std::size_t widest = 0;
  for (std::size_t i = 0; i + 1 < levels.size(); ++i)
    if (levels[i + 1] - levels[i] > levels[widest + 1] - levels[widest]) widest = i;
  const double level = 0.5 * (levels[widest] + levels[widest + 1]);
  std::vector<Vec3> crossings;
  for (const auto& [from, to] : facet.edges) {
    const Vec3 &p = points[position(from)], &q = points[position(to)];
    if ((p[b] > level) != (q[b] > level)) crossings.push_back(p + (level - p[b]) / (q[b] - p[b]) * (q - p));
  }
  std::sort(crossings.begin(), crossings.end(), [c](const Vec3& p, const Vec3& q) { return p[c] < q[c]; });
  Vec3 best = points[position(facet.edges[0][0])];
  double longest = -1;
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
    if ((crossings[i + 1] - crossings[i]).norm() <= longest) continue;
    longest = (crossings[i + 1] - crossings[i]).norm();
    best = 0.5 * (crossings[i] + crossings[i + 1]);
  }
  return best;
}

}  // namespace

Vec3 outline_area_normal(const std::vector<Vec3>& points, const std::vector<int>& outline) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < outline.size(); ++i)
    sum += (points[position(outline[i])] - points[position(outline[0])])
               .cross(points[position(outline[i + 1])] - points[position(outline[0])]);
  return sum;
}

SidedFacet sided_facet(const std::vector<Vec3>& points, const SurfaceFacet& facet) {
  const std::vector<int>& outer = facet.polygons.front();
  SidedFacet sided{directed_edges(outer), outline_area_normal(points, outer).normalized(),
                   points[position(outer[0])]};
  for (std::size_t i = 1; i < facet.polygons.size(); ++i) {
    std::vector<int> outline = facet.polygons[i];
    if (outline.size() < 2) continue;
    const Vec3 turn = outline_area_normal(points, outline);
    const SidedFacet rim{directed_edges(outline), sided.normal, points[position(outline[0])]};
    const bool is_opening =
        std::any_of(facet.openings.begin(), facet.openings.end(),
                    [&](const Vec3& opening) { return foot_is_inside(opening, points, rim); });
    // The facet lies on the left of the rim of an opening: it runs the other way round.
    if (is_opening && turn.dot(sided.normal) > 0) std::reverse(outline.begin(), outline.end());
    for (const auto& edge : directed_edges(outline)) {
      sided.edges.push_back(edge);
      if (!is_opening && outline.size() > 2) sided.edges.push_back({edge[1], edge[0]});
    }
  }
  sided.inside = inner_point(points, sided);
  return sided;
}

SidedFacet sided_facet(const std::vector<Vec3>& points, const std::array<int, 3>& triangle) {
  const auto& [a, b, c] = triangle;
  const Vec3 normal = (points[position(b)] - points[position(a)])
                          .cross(points[position(c)] - points[position(a)])
                          .normalized();
  return {{{a, b}, {b, c}, {c, a}},
          normal,
          (points[position(a)] + points[position(b)] + points[position(c)]) / 3};
}

}  // namespace etendue
