// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/geometry/arrangement/convex_body.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "base/position.h"
#include "mesh/geometry/arrangement/snapping.h"

namespace etendue {
namespace {

/// Closer than this part of its distance from the origin or its radius a vertex is on a plane.
constexpr double kSnap = 1e-13;

void finish(ConvexBody& body) {
  for (const std::vector<int>& face : body.faces)
    body.planes.emplace_back(body.points[position(face[0])], body.points[position(face[1])],
                             body.points[position(face[2])]);
  body.low = body.high = rounded(body.points.front());
  for (const ExactPoint& point : body.points) {
    body.low = body.low.cwiseMin(rounded(point));
    body.high = body.high.cwiseMax(rounded(point));
  }
  // Rounding may have moved a corner inward by its last bit.
  const Vec3 margin = 1e-14 * (body.low.cwiseAbs() + body.high.cwiseAbs());
  body.low -= margin;
  body.high += margin;
}

ConvexBody polyhedron(const BoxPrimitive& box, const SnapPlanes&) {
  ConvexBody body;
  for (int corner = 0; corner < 8; ++corner)
    body.points.emplace_back((corner & 1 ? box.max : box.min).x(), (corner & 2 ? box.max : box.min).y(),
                             (corner & 4 ? box.max : box.min).z());
  body.faces = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  return body;
}

/// The corners of the regular icosahedron, as the corners of three golden rectangles.
std::vector<Vec3> icosahedron_corners() {
  std::vector<Vec3> corners;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double one : {-1.0, 1.0}) {
      for (const double golden : {-std::numbers::phi, std::numbers::phi}) {
        Vec3 corner = Vec3::Zero();
        corner[(axis + 1) % 3] = one;
        corner[(axis + 2) % 3] = golden;
        corners.push_back(corner);
      }
    }
  }
  return corners;
}

/// The twenty triples of neighbouring corners, counter-clockwise from outside.
std::vector<std::array<int, 3>> icosahedron_faces(const std::vector<Vec3>& corners) {
  const auto neighbours = [&](int a, int b) {
    return (corners[position(a)] - corners[position(b)]).norm() < 2.1;
  };
  std::vector<std::array<int, 3>> faces;
  for (int a = 0; a < 12; ++a) {
    for (int b = a + 1; b < 12; ++b) {
      for (int c = b + 1; c < 12; ++c) {
        if (!neighbours(a, b) || !neighbours(b, c) || !neighbours(c, a)) continue;
        const bool outward = corners[position(a)].dot(corners[position(b)].cross(corners[position(c)])) > 0;
        faces.push_back(outward ? std::array{a, b, c} : std::array{a, c, b});
      }
    }
  }
  return faces;
}

Vec3 snapped(Vec3 point, double radius, const SnapPlanes& snap) {
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : snap.sides[position(axis)])
      if (std::abs(point[axis] - side) <= std::max(snap.distance, kSnap * (std::abs(side) + radius)))
        point[axis] = side;
  return point;
}

ConvexBody polyhedron(const SpherePrimitive& sphere, const SnapPlanes& snap) {
  const int parts = icosahedron_parts(sphere.facets);
  const std::vector<Vec3> corners = icosahedron_corners();
  ConvexBody body;
  std::map<std::array<int, 12>, int> numbers;  // by how many parts a vertex is made of each corner
  for (const std::array<int, 3>& face : icosahedron_faces(corners)) {
    const auto vertex = [&](int i, int j) {
      std::array<int, 12> mix{};
      mix[position(face[0])] = parts - i - j;
      mix[position(face[1])] = i;
      mix[position(face[2])] = j;
      const auto [entry, added] = numbers.try_emplace(mix, static_cast<int>(body.points.size()));
      if (added) {
        Vec3 direction = Vec3::Zero();
        for (int corner = 0; corner < 12; ++corner)
          direction += mix[position(corner)] * corners[position(corner)];
        const Vec3 point = sphere.center + sphere.radius * direction.normalized();
        body.points.push_back(exact(snapped(point, sphere.radius, snap)));
      }
      return entry->second;
    };
    for (int i = 0; i < parts; ++i) {
      for (int j = 0; i + j < parts; ++j) {
        body.faces.push_back({vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)});
        if (i + j + 1 < parts)
          body.faces.push_back({vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
      }
    }
  }
  return body;
}

/// Two unit vectors that complete an axis to a right-handed frame; coordinate axes where it is one.
std::array<Vec3, 2> frame_across(const Vec3& axis) {
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    if (axis[j] == 0 && axis[k] == 0)
      return axis[i] > 0 ? std::array<Vec3, 2>{Vec3::Unit(j), Vec3::Unit(k)}
                         : std::array<Vec3, 2>{Vec3::Unit(k), Vec3::Unit(j)};
  }
  const Vec3 across = axis.unitOrthogonal();
  return {across, axis.normalized().cross(across)};
}

/// Ends along the axes are meshed as they are.
bool is_oblique(const Vec3& axis) { return (axis.array() != 0).count() > 1; }

/// The point with the coordinates that it needs to lie on planes; the others stay exact.
ExactPoint snapped_exactly(const ExactPoint& point, const SnapPlanes& snap) {
  std::array<ExactNumber, 3> x{point.x(), point.y(), point.z()};
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const double side : snap.sides[axis])
      if (CGAL::abs(x[axis] - side) <= snap.distance) x[axis] = side;
  return {x[0], x[1], x[2]};
}

/// The ends are exactly flat and the sides exactly parallelograms: the rounded points of a circle are
/// projected onto the plane of one end, and the other end is the same ring moved along the axis.
ConvexBody polyhedron(const CylinderPrimitive& cylinder, const SnapPlanes& snap) {
  const std::array<Vec3, 2> across = frame_across(cylinder.to - cylinder.from);
  const ExactPoint from = exact(cylinder.from);
  const Exact::Vector_3 axis = exact(cylinder.to) - from;
  const int sides = cylinder.facets;
  const bool oblique = is_oblique(cylinder.to - cylinder.from);
  ConvexBody body;
  std::vector<int> first, last;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    const Vec3 circle = cylinder.radius * (std::cos(angle) * across[0] + std::sin(angle) * across[1]);
    const Exact::Vector_3 offset = exact(circle) - CGAL::ORIGIN;
    const ExactPoint point = from + offset - (offset * axis) / (axis * axis) * axis;
    body.points.push_back(oblique ? point : snapped_exactly(point, snap));
    first.insert(first.begin(), i);
    last.push_back(sides + i);
  }
  for (int i = 0; i < sides; ++i) {
    body.points.push_back(body.points[position(i)] + axis);
    const int next = (i + 1) % sides;
    body.faces.push_back({i, next, sides + next, sides + i});
  }
  body.faces.push_back(first);
  body.faces.push_back(last);
  if (oblique) body.middles = {from, from + axis};
  return body;
}

}  // namespace

SnapPlanes snap_planes(const Geometry& geometry) {
  SnapPlanes planes{{}, snap_distance(geometry)};
  for (const Primitive& primitive : geometry.primitives) {
    const auto* box = std::get_if<BoxPrimitive>(&primitive);
    if (!box) continue;
    for (int axis = 0; axis < 3; ++axis)
      planes.sides[position(axis)].insert(planes.sides[position(axis)].end(),
                                          {box->min[axis], box->max[axis]});
  }
  return planes;
}

ConvexBody convex_body(const Primitive& primitive, const SnapPlanes& snap) {
  ConvexBody body = std::visit([&](const auto& shape) { return polyhedron(shape, snap); }, primitive);
  finish(body);
  return body;
}

int icosahedron_parts(int facets) {
  int parts = 1;
  while (10 * ((parts + 1) * (parts + 1) + parts * parts) <= facets) ++parts;
  return parts;
}

bool contains(const ConvexBody& body, const ExactPoint& point) {
  const CGAL::Bbox_3 around = point.bbox();
  for (int axis = 0; axis < 3; ++axis)
    if (around.max(axis) < body.low[axis] || around.min(axis) > body.high[axis]) return false;
  for (const ExactPlane& plane : body.planes)
    if (plane.has_on_positive_side(point)) return false;
  return true;
}

}  // namespace etendue
