// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/form_factors/exchange_area.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace etendue {
namespace {

// Of the smaller area.
constexpr double wanted_accuracy = 1e-9;
// Distance over the sum of both radii from which on points are summed.
constexpr double far_apart = 5;
// Distance from a plane, relative to the size of both patches, below which a corner lies in it.
constexpr double patch_in_plane = 1e-12;

struct HeightRange {
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -std::numeric_limits<double>::infinity();
};

/// Heights of a patch above the plane of another.
HeightRange heights(const FlatPatch& patch, const FlatPatch& plane) {
  HeightRange range;
  for (const TriangleCorners& t : patch.triangles())
    for (const Vec3& corner : t) {
      const double height = plane.normal().dot(corner - plane.centroid());
      range.lowest = std::min(range.lowest, height);
      range.highest = std::max(range.highest, height);
    }
  return range;
}

/// The edges of the part of a patch that lies before the plane of another.
std::vector<ContourEdge> contour_before(const FlatPatch& patch, const FlatPatch& plane) {
  std::vector<ContourEdge> edges;
  for (const TriangleCorners& t : patch.triangles()) {
    const std::vector<Vec3> part = clipped_polygon(t, plane.normal(), plane.offset());
    for (std::size_t i = 0; part.size() > 2 && i < part.size(); ++i)
      if (const Vec3& next = part[(i + 1) % part.size()]; next != part[i]) edges.push_back({part[i], next});
  }
  return edges;
}

double by_contours(const std::vector<ContourEdge>& a, const std::vector<ContourEdge>& b, double unit,
                   double tolerance) {
  double sum = 0;
  const double part = tolerance / static_cast<double>(std::max<std::size_t>(1, a.size() * b.size()));
  for (const ContourEdge& first : a)
    for (const ContourEdge& second : b) sum += contour_integral(first, second, unit, part);
  return std::max(0.0, sum / (2 * std::numbers::pi));
}

double by_points(const FlatPatch& a, const FlatPatch& b) {
  double sum = 0;
  for (const SurfacePoint& p : a.points())
    for (const SurfacePoint& q : b.points()) {
      const Vec3 separation = q.position - p.position;
      const double r2 = separation.squaredNorm();
      sum -= p.area * q.area * a.normal().dot(separation) * b.normal().dot(separation) / (r2 * r2);
    }
  return sum / std::numbers::pi;
}

enum class FarPatches { by_points, by_contours };

double exchange(const FlatPatch& a, const FlatPatch& b, FarPatches far) {
  const double distance = (a.centroid() - b.centroid()).norm();
  const double close = patch_in_plane * (distance + a.radius() + b.radius());
  const HeightRange of_a = heights(a, b), of_b = heights(b, a);
  if (of_a.highest <= close || of_b.highest <= close) return 0;
  const bool a_whole = of_a.lowest >= -close, b_whole = of_b.lowest >= -close;
  if (a_whole && b_whole && far == FarPatches::by_points && distance > far_apart * (a.radius() + b.radius()))
    return by_points(a, b);
  const double unit = std::max(distance, std::max(a.radius(), b.radius()));
  const double tolerance = wanted_accuracy * std::min(a.area(), b.area());
  return by_contours(a_whole ? a.contour() : contour_before(a, b),
                     b_whole ? b.contour() : contour_before(b, a), unit, tolerance);
}

}  // namespace

double exchange_area(const FlatPatch& a, const FlatPatch& b) { return exchange(a, b, FarPatches::by_points); }

double exchange_area_by_contours(const FlatPatch& a, const FlatPatch& b) {
  return exchange(a, b, FarPatches::by_contours);
}

}  // namespace etendue
