// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/closed_form/flat_shape.h"

#include <algorithm>
#include <cmath>

#include "base/quadrature/simplex_rules.h"
#include "solver/uncollided/closed_form/outline.h"
#include "solver/uncollided/closed_form/side_light.h"
#include "solver/uncollided/closed_form/triangle.h"
#include "solver/uncollided/closed_form/uniform_emitters.h"

namespace etendue {
namespace {

/// More sides than these cost more than groups of triangles do.
constexpr std::size_t most_shapes = 6, most_sides = 24;
/// Parts with sides of at most so many times their distance are seen as points of a rule.
constexpr double largest_part_side = 0.7;
/// A shape is far, and seen as points of a rule, where its size is less than this part of its distance.
constexpr double far = 0.35;
/// Solid angles of which the sides leave no more than that are differences of larger numbers.
constexpr double cancelled = 1e-5;

/// Sums of a rule of degree 5 over parts that are as small as they are near.
struct Rule {
  double extinction;
  FlatShape::View clear = {}, left = {};

  /// `corners` seen from the eye; `above` is its height times the area.
  void add(const Triangle& corners, double above) {
    const auto& [a, b, c] = corners;
    if (longest_side(corners) > largest_part_side * ((a + b + c) / 3).norm()) {
      const Vec3 ab = (a + b) / 2, bc = (b + c) / 2, ca = (c + a) / 2;
      for (const Triangle& part : {Triangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
        add(part, above / 4);
      return;
    }
    for (const FacePointWeight& point : seven_point_rule()) {
      const Vec3 separation = point.barycentric[0] * a + point.barycentric[1] * b + point.barycentric[2] * c;
      const double distance = separation.norm();
      const double part = point.weight * above / (distance * distance * distance);
      const double arrives = part * std::exp(-extinction * distance);
      clear.fluence += part;
      clear.flux -= part / distance * separation;
      left.fluence += arrives;
      left.flux -= arrives / distance * separation;
    }
  }
};

}  // namespace

double signed_solid_angle(const std::array<Vec3, 3>& corners) {
  const Vec3 &p = corners[0], &q = corners[1], &r = corners[2];
  const double a = p.norm(), b = q.norm(), c = r.norm();
  const double below = a * b * c + p.dot(q) * c + q.dot(r) * a + r.dot(p) * b;
  return 2 * std::atan2(p.dot(q.cross(r)), below);
}

FlatShape::FlatShape(std::span<const Triangle> triangles) : sides_(outline(triangles)) {
  Vec3 area = Vec3::Zero();
  for (const Triangle& triangle : triangles) area += area_vector(triangle);
  normal_ = area.normalized();
  for (const Side& side : sides_) size_ = std::max(size_, (side.first - sides_.front().first).norm());
}

double FlatShape::height(const Vec3& eye) const {
  const double height = normal_.dot(eye - sides_.front().first);
  return height <= rounding_height * size_ ? 0 : height;
}

std::vector<std::size_t> FlatShape::sides_at(const Vec3& point, double distance) const {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < sides_.size(); ++i)
    if (distance_to_side(point, sides_[i].first, sides_[i].second) <= distance) found.push_back(i);
  return found;
}

// The solid angle is the sum of those of the triangles between the sides and any point of the plane, each
// with the sign of its turn; seen from the front corners stand clockwise about the line of sight.
FlatShape::View FlatShape::from(const Vec3& eye) const {
  View view;
  if (height(eye) == 0) return view;
  const Vec3 apex = sides_.front().first - eye;
  for (const auto& [first, second] : sides_) {
    const Vec3 a = first - eye, b = second - eye;
    const Vec3 across = a.cross(b);
    const double sine = across.norm();
    // A side that points at the eye spans no angle.
    if (sine > 0) view.flux += std::atan2(sine, a.dot(b)) / (2 * sine) * across;
    view.fluence -= signed_solid_angle({apex, a, b});
  }
  return view;
}

FlatShape::View FlatShape::from(const Vec3& eye, double extinction) const {
  const double above = height(eye);
  if (above == 0 || extinction == 0) return from(eye);
  if (size_ > far * (eye - sides_.front().first).norm()) {
    const View view = by_sides(eye, above, extinction);
    if (view.fluence > cancelled) return view;
  }
  return by_parts(eye, above, extinction);
}

FlatShape::View FlatShape::by_sides(const Vec3& eye, double height, double extinction) const {
  const Vec3 foot = eye - height * normal_;
  const FootIntegrals below(height, extinction);
  View view;
  for (const auto& [first, second] : sides_) {
    const Vec3 along = (second - first).normalized(), outward = along.cross(normal_);
    const SideLight light =
        light_of_side({height, outward.dot(first - foot), along.dot(first - foot), along.dot(second - foot)},
                      extinction, below);
    view.fluence += light.fluence;
    view.flux += light.upward * normal_ + light.outward * outward;
  }
  return view;
}

// The rule is asked only for what differs from empty space.
FlatShape::View FlatShape::by_parts(const Vec3& eye, double height, double extinction) const {
  const Vec3 apex = sides_.front().first - eye;
  Rule rule{extinction};
  for (const auto& [first, second] : sides_) {
    const Triangle part{apex, first - eye, second - eye};
    const double area = normal_.dot(area_vector(part));
    if (area != 0) rule.add(part, height * area);
  }
  const View clear = from(eye);
  const double left = rule.left.fluence / rule.clear.fluence;
  return {left * clear.fluence, left * clear.flux + (rule.left.flux - left * rule.clear.flux)};
}

std::vector<std::pair<FlatShape, std::vector<double>>> flat_shapes(std::span<const EmitterPart> triangles) {
  const auto emitters = uniform_emitters(triangles, most_shapes);
  if (!emitters) return {};
  std::vector<std::pair<FlatShape, std::vector<double>>> shapes;
  std::size_t sides = 0;
  for (const UniformEmitter& emitter : *emitters) {
    shapes.emplace_back(FlatShape(emitter.triangles), emitter.radiance);
    sides += shapes.back().first.side_count();
    if (sides > most_sides) return {};
  }
  return shapes;
}

}  // namespace etendue
