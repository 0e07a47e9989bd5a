// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/solver/uncollided/visible_part.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/quadrature/gauss_legendre.h"

namespace etendue {
namespace {

using std::numbers::pi;
using Polygon = std::vector<Vec3>;

/// Twice the area of a triangle seen from above, positive if its corners are counterclockwise.
double turn(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

double area_of(const Polygon& polygon) {
  double sum = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i) sum += turn(polygon[0], polygon[i - 1], polygon[i]) / 2;
  return sum;
}

/// Counterclockwise (Andrew 1979).
Polygon convex_hull(Polygon points) {
  std::ranges::sort(points, [](const Vec3& a, const Vec3& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  Polygon hull;
  for (int side = 0; side < 2; ++side, std::ranges::reverse(points)) {
    const std::size_t start = hull.size();
    for (const Vec3& point : points) {
      while (hull.size() > start + 1 && turn(hull[hull.size() - 2], hull.back(), point) <= 0) hull.pop_back();
      hull.push_back(point);
    }
    hull.pop_back();
  }
  return hull;
}

/// Of two convex polygons; the second counterclockwise (Sutherland and Hodgman 1974).
Polygon intersection(Polygon polygon, const Polygon& window) {
  for (std::size_t i = 0; i < window.size(); ++i) {
    const Vec3 &a = window[i], &b = window[(i + 1) % window.size()];
    Polygon kept;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Vec3 &from = polygon[k], &to = polygon[(k + 1) % polygon.size()];
      const double before = turn(a, b, from), after = turn(a, b, to);
      if (before >= 0) kept.push_back(from);
      if ((before > 0 && after < 0) || (before < 0 && after > 0))
        kept.emplace_back(from + before / (before - after) * (to - from));
    }
    polygon = std::move(kept);
  }
  return polygon;
}

/// The sum of its angles above that of a flat one; half of the angles of its sides, each about its normal.
VisibleLight clear_light(const Polygon& polygon, const Vec3& eye) {
  const std::size_t count = polygon.size();
  VisibleLight light;
  if (count < 3) return light;
  std::vector<Vec3> sides(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 a = polygon[i] - eye, b = polygon[(i + 1) % count] - eye;
    const double across = a.cross(b).norm();
    if (across > 0) sides[i] = a.cross(b) / across;
    light.irradiance += std::atan2(across, a.dot(b)) * sides[i].z() / 2;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 &before = sides[(i + count - 1) % count], &after = sides[i];
    light.fluence -= std::atan2(before.cross(after).norm(), before.dot(after));
  }
  light.fluence += 2 * pi;
  return light;
}

/// Exponential integrals of order 2 and 3 (Abramowitz and Stegun 1964, eq. 5.1.14).
std::array<double, 2> exponential_integrals(double x) {
  const double second = x > 0 ? std::exp(-x) + x * std::expint(-x) : 1;
  return {second, (std::exp(-x) - x * second) / 2};
}

/// In polar coordinates about the point of the light's plane above the eye, at the height h,
///
///     fluence = closed integral of E_2(s h) - E_2(s r) h / r over the azimuth,
///     irradiance that of E_3(s h) - E_3(s r) h^2 / r^2,
///
/// r being the distance of the outline from the eye: on a side r^2 = h^2 + d^2 cosh^2(v), with the distance d
/// of the side's line from the pole and d sinh(v) from the foot of the perpendicular, where the azimuth grows
/// by dv / cosh(v). As a function of v all is smooth however small d is.
VisibleLight dimmed_light(const Polygon& polygon, const Vec3& eye, double extinction) {
  static const GaussRule rule = gauss_legendre(16);
  constexpr double widest = 1.5;
  VisibleLight light;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 from = polygon[i] - eye, to = polygon[(i + 1) % polygon.size()] - eye;
    const Vec3 along = (to - from).normalized();
    const double height = from.z(), turning = from.x() * along.y() - from.y() * along.x();
    const double distance = std::abs(turning);
    if (distance == 0) continue;
    const double first = std::asinh(from.dot(along) / distance);
    const double range = std::asinh(to.dot(along) / distance) - first;
    const int parts = static_cast<int>(std::ceil(range / widest));
    const auto near = exponential_integrals(extinction * height);
    for (int part = 0; part < parts; ++part)
      for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
        const double stretch = std::cosh(first + range / parts * (part + (1 + rule.nodes[k]) / 2));
        const double r = std::hypot(height, distance * stretch), slope = height / r;
        const auto far = exponential_integrals(extinction * r);
        const double weight = std::copysign(rule.weights[k] * range / parts / 2 / stretch, turning);
        light.fluence += weight * (near[0] - far[0] * slope);
        light.irradiance += weight * (near[1] - far[1] * slope * slope);
      }
  }
  return light;
}

}  // namespace

VisibleLight light_of_polygon(const std::vector<Vec3>& polygon, const Vec3& eye, double extinction) {
  return extinction > 0 ? dimmed_light(polygon, eye, extinction) : clear_light(polygon, eye);
}

HalfHiddenLight::HalfHiddenLight(std::vector<Vec3> light, std::vector<Vec3> body)
    : light_(std::move(light)), body_(std::move(body)) {
  if (area_of(light_) < 0) std::ranges::reverse(light_);
}

// The corners of the body as they are seen against the light's plane.
std::vector<Vec3> HalfHiddenLight::hidden_part(const Vec3& eye) const {
  std::vector<Vec3> outline;
  const double height = light_[0].z() - eye.z();
  for (const Vec3& corner : body_) {
    const Vec3 separation = corner - eye;
    outline.emplace_back(eye + height / separation.z() * separation);
    outline.back().z() = light_[0].z();
  }
  return intersection(light_, convex_hull(outline));
}

VisibleLight HalfHiddenLight::whole_from(const Vec3& eye, double extinction) const {
  return light_of_polygon(light_, eye, extinction);
}

VisibleLight HalfHiddenLight::seen_from(const Vec3& eye, double extinction) const {
  const VisibleLight whole = whole_from(eye, extinction),
                     hidden = light_of_polygon(hidden_part(eye), eye, extinction);
  return {whole.fluence - hidden.fluence, whole.irradiance - hidden.irradiance};
}

double HalfHiddenLight::visible_area(const Vec3& eye) const { return area() - area_of(hidden_part(eye)); }

double HalfHiddenLight::area() const { return area_of(light_); }

}  // namespace etendue
