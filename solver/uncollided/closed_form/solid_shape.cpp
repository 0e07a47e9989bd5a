// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/closed_form/solid_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "solver/uncollided/closed_form/exponential_integrals.h"
#include "solver/uncollided/closed_form/outline.h"
#include "solver/uncollided/closed_form/side_points.h"
#include "solver/uncollided/closed_form/triangle.h"

namespace etendue {
namespace {

/// More than these cost more than groups of tetrahedra do.
constexpr std::size_t most_bodies = 6, most_solid_edges = 60;
/// A body of this optical size is one in empty space but for so much.
constexpr double thinnest = 1e-13;

using Tetrahedron = std::array<Vec3, 4>;

/// Corners counterclockwise as seen from outside.
std::array<Triangle, 4> faces_of(Tetrahedron t) {
  if ((t[1] - t[0]).cross(t[2] - t[0]).dot(t[3] - t[0]) < 0) std::swap(t[0], t[1]);
  return {Triangle{t[0], t[2], t[1]}, {t[0], t[1], t[3]}, {t[0], t[3], t[2]}, {t[1], t[2], t[3]}};
}

/// The faces that only one tetrahedron has.
std::vector<Triangle> surface(std::span<const Tetrahedron> tetrahedra) {
  using Key = std::array<std::array<double, 3>, 3>;
  std::map<Key, Triangle> single;
  for (const Tetrahedron& tetrahedron : tetrahedra)
    for (const Triangle& triangle : faces_of(tetrahedron)) {
      Key key;
      for (std::size_t i = 0; i < 3; ++i) key[i] = {triangle[i].x(), triangle[i].y(), triangle[i].z()};
      std::sort(key.begin(), key.end());
      if (single.erase(key) == 0) single.emplace(key, triangle);
    }
  std::vector<Triangle> triangles;
  for (const auto& [key, triangle] : single) triangles.push_back(triangle);
  return triangles;
}

struct Plane {
  Vec3 normal;
  double offset;
  std::vector<Triangle> triangles;
};

/// No more than one above the largest number of edges: such a body is not taken.
std::vector<Plane> planes_of(std::span<const Triangle> triangles, double size) {
  std::vector<Plane> planes;
  for (const Triangle& triangle : triangles) {
    const Vec3 normal = area_vector(triangle).normalized();
    const double offset = normal.dot(triangle[0]);
    auto plane = std::find_if(planes.begin(), planes.end(), [&](const Plane& other) {
      return (other.normal - normal).norm() < one_plane && std::abs(other.offset - offset) < one_plane * size;
    });
    if (plane == planes.end()) {
      // A face has three edges at least, each of them another one too.
      if (planes.size() > most_solid_edges) break;
      plane = planes.insert(plane, {normal, offset, {}});
    }
    plane->triangles.push_back(triangle);
  }
  return planes;
}

/// R(x) and P(x), without loss of digits where x is small.
struct Deficits {
  explicit Deficits(const Eight& x) {
    const ExponentialIntegrals integrals = exponential_integrals(x);
    // (1 - e^-x) / x
    const Eight mean = (x < 0.05).select(1 - x / 2 * (1 - x / 3 * (1 - x / 4 * (1 - x / 5 * (1 - x / 6)))),
                                         (1 - (-x).exp()) / x);
    r = mean + integrals.first;
    p = (mean + integrals.second) / 2;
  }
  Eight r, p;
};

/// A face as the eye sees it, and its integrals over the surface.
struct SeenFace {
  double height;          ///< above the eye [length]
  double r = 0, p = 0;    ///< R(a|h|), |h| P(a|h|)
  double across = 0;      ///< of (1 - e^(-ar)) / (a r^3)
  double lengthwise = 0;  ///< of E_2(ar) / r
};

}  // namespace

SolidShape::SolidShape(std::span<const Tetrahedron> tetrahedra) {
  const std::vector<Triangle> triangles = surface(tetrahedra);
  for (const Triangle& triangle : triangles)
    for (const Vec3& corner : triangle) size_ = std::max(size_, (corner - triangles[0][0]).norm());
  std::map<std::array<double, 6>, std::size_t> open;  // edges of one face, by their ends
  const auto key = [](const Vec3& a, const Vec3& b) {
    return std::array<double, 6>{a.x(), a.y(), a.z(), b.x(), b.y(), b.z()};
  };
  for (const Plane& plane : planes_of(triangles, size_)) {
    Vec3 area = Vec3::Zero();
    for (const Triangle& triangle : plane.triangles) area += area_vector(triangle);
    const Vec3 normal = area.normalized();
    for (const auto& [first, second] : outline(plane.triangles)) {
      const auto twin = open.find(key(second, first));
      if (twin == open.end()) {
        open.emplace(key(first, second), edges_.size());
        edges_.push_back({first, second, faces_.size(), {}});
      } else {
        edges_[twin->second].twin = faces_.size();
        open.erase(twin);
      }
    }
    faces_.push_back({normal, normal.dot(plane.triangles[0][0])});
  }
}

SolidShape::View SolidShape::from(const Vec3& eye, double extinction) const {
  const double a = std::max(extinction, thinnest / size_);
  std::vector<SeenFace> seen(faces_.size());
  for (std::size_t begin = 0; begin < faces_.size(); begin += 8) {
    const std::size_t count = std::min<std::size_t>(8, faces_.size() - begin);
    Eight height = Eight::Ones();
    for (std::size_t i = 0; i < count; ++i) {
      const Face& face = faces_[begin + i];
      seen[begin + i].height = face.offset - face.normal.dot(eye);
      height[static_cast<Eigen::Index>(i)] = std::abs(seen[begin + i].height);
    }
    height = height.max(std::numeric_limits<double>::min());
    const Deficits deficits(a * height);
    for (std::size_t i = 0; i < count; ++i) {
      const auto lane = static_cast<Eigen::Index>(i);
      seen[begin + i].r = deficits.r[lane];
      seen[begin + i].p = height[lane] * deficits.p[lane];
    }
  }
  for (const Edge& edge : edges_) {
    const Vec3 along = (edge.second - edge.first).normalized(), to_first = edge.first - eye;
    const double first = along.dot(to_first), last = along.dot(edge.second - eye);
    const Vec3 aside = to_first - first * along;
    const double near = aside.norm();
    if (near == 0) continue;
    for_points_of_side(near, first, last, [&](const SidePoints& points) {
      const auto& [r, s, length] = points;
      const Deficits deficits(a * r);
      const auto add = [&, &r = r, &s = s, &length = length](SeenFace& face, const Vec3& outward) {
        const double distance = outward.dot(aside);
        const Eight angle = distance * length / (distance * distance + s * s);
        face.across += (angle * (face.r - deficits.r)).sum();
        face.lengthwise += (angle * (r * deficits.p - face.p)).sum();
      };
      add(seen[edge.face], along.cross(faces_[edge.face].normal));
      if (edge.twin) add(seen[*edge.twin], -along.cross(faces_[*edge.twin].normal));
    });
  }
  View view;
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    view.fluence += seen[f].height * seen[f].across;
    view.flux += seen[f].lengthwise * faces_[f].normal;
  }
  return view;
}

// A foot is in a face where the sides turn about it once.
double SolidShape::distance_to_surface(const Vec3& point) const {
  double nearest = std::numeric_limits<double>::infinity();
  std::vector<double> turn(faces_.size(), 0);
  for (const Edge& edge : edges_) {
    nearest = std::min(nearest, distance_to_side(point, edge.first, edge.second));
    const auto add = [&](std::size_t face, double sign) {
      const Vec3& normal = faces_[face].normal;
      const Vec3 a = edge.first - point, b = edge.second - point;
      const Vec3 p = a - normal.dot(a) * normal, q = b - normal.dot(b) * normal;
      turn[face] += sign * std::atan2(normal.dot(p.cross(q)), p.dot(q));
    };
    add(edge.face, 1);
    if (edge.twin) add(*edge.twin, -1);
  }
  for (std::size_t f = 0; f < faces_.size(); ++f)
    if (turn[f] > 1) nearest = std::min(nearest, std::abs(faces_[f].offset - faces_[f].normal.dot(point)));
  return nearest;
}

std::vector<ConvexFace> SolidShape::convex_faces() const {
  std::vector<std::vector<Side>> sides(faces_.size());
  for (const Edge& edge : edges_) {
    if (!edge.twin) return {};
    sides[edge.face].emplace_back(edge.first, edge.second);
    sides[*edge.twin].emplace_back(edge.second, edge.first);
    for (const Face& face : faces_)
      if (face.normal.dot(edge.first) - face.offset > one_plane * size_) return {};
  }
  std::vector<ConvexFace> convex;
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    convex.push_back({{sides[f].front().first}, faces_[f].normal});
    std::vector<Vec3>& corners = convex.back().corners;
    while (corners.size() < sides[f].size()) {
      const auto next = std::find_if(sides[f].begin(), sides[f].end(),
                                     [&](const Side& side) { return side.first == corners.back(); });
      if (next == sides[f].end()) return {};
      corners.push_back(next->second);
    }
  }
  return convex;
}

std::vector<std::size_t> SolidShape::edges_at(const Vec3& point, double distance) const {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < edges_.size(); ++i)
    if (distance_to_side(point, edges_[i].first, edges_[i].second) <= distance) found.push_back(i);
  return found;
}

std::vector<std::pair<SolidShape, std::vector<double>>> solid_shapes(
    std::span<const EmitterPart> tetrahedra) {
  std::vector<std::pair<std::vector<double>, std::vector<Tetrahedron>>> groups;
  for (const EmitterPart& part : tetrahedra) {
    auto group = std::find_if(groups.begin(), groups.end(),
                              [&](const auto& other) { return other.first == part.brightness; });
    if (group == groups.end()) {
      if (groups.size() == most_bodies) return {};
      group = groups.insert(group, {part.brightness, {}});
    }
    group->second.push_back(part.corners);
  }
  std::vector<std::pair<SolidShape, std::vector<double>>> shapes;
  std::size_t edges = 0;
  for (const auto& [emission, members] : groups) {
    shapes.emplace_back(SolidShape(members), emission);
    edges += shapes.back().first.edge_count();
    if (edges > most_solid_edges || shapes.back().first.face_count() > most_solid_edges) return {};
  }
  return shapes;
}

}  // namespace etendue
