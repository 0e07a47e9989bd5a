// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/lights/flat_shape.h"

#include <algorithm>
#include <cmath>

namespace etendue {
namespace {

/// Unit normals that agree to this, and offsets to this part of the size, are those of one plane.
constexpr double one_plane = 1e-6;
/// More sides than these cost more than groups of triangles do.
constexpr std::size_t most_shapes = 6, most_sides = 24;
/// Chords of the unit sphere up to which a rule of degree 5 sees a mean distance.
constexpr double largest_side = 0.9;
/// An eye that is so near to the plane, in units of the size, lies in it but for rounding.
constexpr double in_plane = 1e-10;
/// Sides that turn by less than this lie in one line.
constexpr double straight = 1e-9;

using Triangle = std::array<Vec3, 3>;
using Side = std::pair<Vec3, Vec3>;

Vec3 area_vector(const Triangle& t) { return (t[1] - t[0]).cross(t[2] - t[0]) / 2; }

/// The sides that only one triangle has.
std::vector<Side> outline(std::span<const Triangle> triangles) {
  std::vector<Side> sides;
  for (const Triangle& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Side side{t[i], t[(i + 1) % 3]};
      const auto twin = std::find(sides.begin(), sides.end(), Side{side.second, side.first});
      if (twin == sides.end())
        sides.push_back(side);
      else
        sides.erase(twin);
    }
  return sides;
}

bool in_line(const Side& a, const Side& b) {
  const Vec3 x = a.second - a.first, y = b.second - b.first;
  return x.cross(y).norm() < straight * x.norm() * y.norm() && x.dot(y) > 0;
}

/// Joins sides that go on in one line.
void join(std::vector<Side>& sides) {
  for (std::size_t i = 0; i < sides.size();) {
    const auto next = std::find_if(sides.begin(), sides.end(), [&](const Side& side) {
      return side.first == sides[i].second && in_line(sides[i], side);
    });
    if (next == sides.end()) {
      ++i;
      continue;
    }
    sides[i].second = next->second;
    const auto place = static_cast<std::size_t>(next - sides.begin());
    sides.erase(next);
    i = place < i ? i - 1 : i;
  }
}

struct Group {
  Vec3 normal;
  double offset;
  std::vector<double> radiance;
  std::vector<Triangle> triangles;
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
  join(sides_);
  for (const Side& side : sides_) size_ = std::max(size_, (side.first - sides_.front().first).norm());
}

// The solid angle is the sum of those of the triangles between the sides and any point of the plane, each
// with the sign of its turn; seen from the front corners stand clockwise about the line of sight.
FlatShape::View FlatShape::from(const Vec3& eye, std::vector<SolidAnglePoint>& points) const {
  const Vec3 apex = sides_.front().first - eye;
  const double height = -normal_.dot(apex);
  View view;
  if (height <= in_plane * size_) return view;
  double seen = 0, way = 0;
  for (const auto& [first, second] : sides_) {
    const Vec3 a = first - eye, b = second - eye;
    const Vec3 across = a.cross(b);
    const double sine = across.norm();
    // A side that points at the eye spans no angle.
    if (sine > 0) view.flux += std::atan2(sine, a.dot(b)) / (2 * sine) * across;
    const double part = -signed_solid_angle({apex, a, b});
    view.solid_angle += part;
    if (part == 0) continue;
    points.clear();
    append_points({apex, a, b}, largest_side, TriangleRule::seven_points, points);
    const double sign = part > 0 ? 1 : -1;
    for (const SolidAnglePoint& point : points) {
      seen += sign * point.weight;
      way -= sign * point.weight * height / normal_.dot(point.direction);
    }
  }
  if (seen > 0) view.way = way / seen;
  return view;
}

std::vector<std::pair<FlatShape, std::vector<double>>> flat_shapes(std::span<const EmitterPart> triangles) {
  std::vector<Group> groups;
  for (const EmitterPart& part : triangles) {
    const Triangle triangle = {part.corners[0], part.corners[1], part.corners[2]};
    const Vec3 normal = area_vector(triangle).normalized();
    const double size = (triangle[1] - triangle[0]).norm();
    const auto same = [&](const Group& group) {
      return group.radiance == part.brightness && (group.normal - normal).norm() < one_plane &&
             std::abs(normal.dot(triangle[0]) - group.offset) < one_plane * size;
    };
    auto group = std::find_if(groups.begin(), groups.end(), same);
    if (group == groups.end()) {
      if (groups.size() == most_shapes) return {};
      group = groups.insert(group, {normal, normal.dot(triangle[0]), part.brightness, {}});
    }
    group->triangles.push_back(triangle);
  }
  std::vector<std::pair<FlatShape, std::vector<double>>> shapes;
  std::size_t sides = 0;
  for (const Group& group : groups) {
    shapes.emplace_back(FlatShape(group.triangles), group.radiance);
    sides += shapes.back().first.side_count();
    if (sides > most_sides) return {};
  }
  return shapes;
}

}  // namespace etendue
