// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/mesh/geometry/surface_measures.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <set>
#include <vector>

namespace etendue {
namespace {

using Segment = std::array<Vec3, 2>;

std::vector<Segment> segments_of(const SurfaceComplex& surface, const SurfaceFacet& facet) {
  std::vector<Segment> segments;
  for (const std::vector<int>& polygon : facet.polygons) {
    if (polygon.size() == 1) continue;
    const std::size_t count = polygon.size() == 2 ? 1 : polygon.size();
    for (std::size_t i = 0; i < count; ++i)
      segments.push_back({surface.points[static_cast<std::size_t>(polygon[i])],
                          surface.points[static_cast<std::size_t>(polygon[(i + 1) % polygon.size()])]});
  }
  return segments;
}

Vec3 unit_normal(const std::vector<Segment>& segments) {
  const Vec3 along = segments[0][1] - segments[0][0];
  Vec3 best = Vec3::Zero();
  for (const Segment& s : segments) {
    for (const Vec3& end : s) {
      const Vec3 normal = along.cross(end - segments[0][0]);
      if (normal.norm() > best.norm()) best = normal;
    }
  }
  return best.normalized();
}

}  // namespace

double facet_area(const SurfaceComplex& surface, const SurfaceFacet& facet) {
  const std::vector<Segment> segments = segments_of(surface, facet);
  const Vec3 normal = unit_normal(segments);
  int axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  const int b = (axis + 1) % 3, c = (axis + 2) % 3;
  std::set<double> cuts;
  for (const Segment& s : segments)
    for (const Vec3& end : s) cuts.insert(end[b]);
  // Between two cuts no segment ends: the facet is a row of trapezoids there.
  double area = 0;
  for (auto cut = cuts.begin(); std::next(cut) != cuts.end(); ++cut) {
    const double middle = 0.5 * (*cut + *std::next(cut));
    std::vector<double> crossings;
    for (const Segment& s : segments) {
      if ((s[0][b] < middle) == (s[1][b] < middle)) continue;
      const double t = (middle - s[0][b]) / (s[1][b] - s[0][b]);
      crossings.push_back(s[0][c] + t * (s[1][c] - s[0][c]));
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
      area += (crossings[i + 1] - crossings[i]) * (*std::next(cut) - *cut);
  }
  return area / std::abs(normal[axis]);
}

std::map<std::string, double> wall_areas(const SurfaceComplex& surface) {
  std::map<std::string, double> areas;
  for (const SurfaceFacet& facet : surface.facets) {
    const std::string name =
        facet.wall < 0 ? "" : surface.wall_names.at(static_cast<std::size_t>(facet.wall));
    areas[name] += facet_area(surface, facet);
  }
  return areas;
}

std::map<std::string, int> seed_counts(const SurfaceComplex& surface) {
  std::map<std::string, int> counts;
  for (const RegionSeed& seed : surface.seeds)
    ++counts[surface.region_names.at(static_cast<std::size_t>(seed.region))];
  return counts;
}

}  // namespace etendue
