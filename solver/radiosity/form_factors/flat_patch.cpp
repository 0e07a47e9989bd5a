// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/form_factors/flat_patch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

namespace etendue {
namespace {

// Sine of the angle between edges that lie in one line.
constexpr double in_line = 1e-10;

Vec3 area_normal(const TriangleCorners& t) { return (t[1] - t[0]).cross(t[2] - t[0]) / 2; }

using Key = std::tuple<double, double, double>;
Key key_of(const Vec3& p) { return {p[0], p[1], p[2]}; }

/// Edges without their opposite.
std::vector<ContourEdge> outline(const std::vector<TriangleCorners>& triangles) {
  std::map<std::pair<Key, Key>, ContourEdge> edges;
  for (const TriangleCorners& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const ContourEdge edge{t[i], t[(i + 1) % 3]};
      const Key from = key_of(edge.from), to = key_of(edge.to);
      if (edges.erase({to, from}) == 0) edges.emplace(std::pair(from, to), edge);
    }
  std::vector<ContourEdge> result;
  for (const auto& [ends, edge] : edges) result.push_back(edge);
  return result;
}

bool continues(const ContourEdge& a, const ContourEdge& b) {
  const Vec3 u = (a.to - a.from).normalized(), v = (b.to - b.from).normalized();
  return u.dot(v) > 0 && u.cross(v).norm() < in_line;
}

/// Joins edges in one line that follow each other where no other edge meets them.
std::vector<ContourEdge> joined_edges(std::vector<ContourEdge> edges) {
  std::multimap<Key, std::size_t> starts;
  for (std::size_t i = 0; i < edges.size(); ++i) starts.emplace(key_of(edges[i].from), i);
  std::vector<char> taken(edges.size(), 0);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (taken[i] != 0) continue;
    for (;;) {
      const auto [first, last] = starts.equal_range(key_of(edges[i].to));
      if (first == last || std::next(first) != last) break;
      const std::size_t next = first->second;
      if (next == i || taken[next] != 0 || !continues(edges[i], edges[next])) break;
      edges[i].to = edges[next].to;
      taken[next] = 1;
    }
  }
  std::vector<ContourEdge> result;
  for (std::size_t i = 0; i < edges.size(); ++i)
    if (taken[i] == 0) result.push_back(edges[i]);
  return result;
}

void append_points(const TriangleCorners& t, double a, double weight, std::vector<SurfacePoint>& points) {
  for (std::size_t i = 0; i < 3; ++i)
    points.push_back({(1 - 2 * a) * t[i] + a * (t[(i + 1) % 3] + t[(i + 2) % 3]), weight});
}

std::vector<SurfacePoint> rule_on(const std::vector<TriangleCorners>& triangles) {
  std::vector<SurfacePoint> points;
  for (const TriangleCorners& t : triangles) {
    const double area = area_normal(t).norm();
    if (triangles.size() > 1) {
      append_points(t, 1. / 6, area / 3, points);
      continue;
    }
    // Radon 1948, degree 5.
    const double root = std::sqrt(15.0);
    points.push_back({(t[0] + t[1] + t[2]) / 3, area * 9 / 40});
    append_points(t, (6 - root) / 21, area * (155 - root) / 1200, points);
    append_points(t, (6 + root) / 21, area * (155 + root) / 1200, points);
  }
  return points;
}

}  // namespace

FlatPatch::FlatPatch(std::vector<TriangleCorners> triangles) : triangles_(std::move(triangles)) {
  for (const TriangleCorners& t : triangles_) {
    const Vec3 normal = area_normal(t);
    normal_ += normal;
    area_ += normal.norm();
    centroid_ += normal.norm() / 3 * (t[0] + t[1] + t[2]);
  }
  normal_.normalize();
  centroid_ /= area_;
  for (const TriangleCorners& t : triangles_)
    for (const Vec3& corner : t) radius_ = std::max(radius_, (corner - centroid_).norm());
  contour_ = joined_edges(outline(triangles_));
  points_ = rule_on(triangles_);
}

Vec3 FlatPatch::point_at(double u, double v) const {
  double rest = u * area_;
  for (const TriangleCorners& t : triangles_) {
    const double area = area_normal(t).norm();
    if (rest > area && &t != &triangles_.back()) {
      rest -= area;
      continue;
    }
    const double root = std::sqrt(std::clamp(rest / area, 0.0, 1.0));
    return (1 - root) * t[0] + root * (1 - v) * t[1] + root * v * t[2];
  }
  return centroid_;
}

FlatPatch FlatPatch::polygon(Corners corners) {
  std::vector<TriangleCorners> triangles;
  for (std::size_t i = 2; i < corners.size(); ++i)
    triangles.push_back({corners[0], corners[i - 1], corners[i]});
  return FlatPatch(std::move(triangles));
}

}  // namespace etendue
