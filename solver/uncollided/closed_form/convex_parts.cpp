// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/closed_form/convex_parts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/clipped_polygon.h"
#include "solver/uncollided/closed_form/outline.h"

namespace etendue {
namespace {

constexpr std::size_t most_parts = 32, most_sides_of_piece = 64, most_single_sides = 2000;
/// Of the size: what is nearer lies on a line. Of the area: what is covered to this is covered.
constexpr double on_line = 1e-10, same_cover = 1e-9;

using Polygon = std::vector<Vec3>;

Vec3 centroid_of(const Polygon& polygon) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& corner : polygon) sum += corner;
  return sum / static_cast<double>(polygon.size());
}

/// Cuts a rectangle about a piece along the sides of its outline, each where it runs through a part. All
/// parts go counterclockwise about the normal.
class PieceParts {
 public:
  PieceParts(std::span<const std::array<Vec3, 3>> triangles, const Vec3& normal)
      : normal_(normal), sides_(outline(triangles)) {
    const Vec3& first = triangles.front()[0];
    const Vec3 along = (triangles.front()[1] - first).normalized(), across = normal.cross(along);
    double area = 0;
    std::array<double, 4> bounds{};
    for (const std::array<Vec3, 3>& triangle : triangles) {
      area += triangle_area(triangle);
      for (const Vec3& corner : triangle) {
        const double x = along.dot(corner - first), y = across.dot(corner - first);
        bounds = {std::min(bounds[0], x), std::max(bounds[1], x), std::min(bounds[2], y),
                  std::max(bounds[3], y)};
      }
    }
    area_ = area;
    const auto at = [&](std::size_t x, std::size_t y) -> Vec3 {
      return first + bounds[x] * along + bounds[2 + y] * across;
    };
    parts_ = {{at(0, 0), at(1, 0), at(1, 1), at(0, 1)}};
    touching_ = on_line * (at(0, 0) - at(1, 1)).norm();
  }

  std::vector<Polygon> find() {
    if (sides_.size() > most_sides_of_piece) return {};
    for (const Side& side : sides_) {
      cut_along(side);
      if (parts_.size() > 2 * most_parts) return {};
    }
    std::erase_if(parts_, [this](const Polygon& part) { return !holds(centroid_of(part)); });
    double covered = 0;
    for (const Polygon& part : parts_) covered += polygon_area(part);
    if (parts_.size() > most_parts || std::abs(covered - area_) > same_cover * area_) return {};
    return std::move(parts_);
  }

 private:
  Vec3 left_of(const Side& side) const { return normal_.cross(side.second - side.first).normalized(); }

  void cut_along(const Side& side) {
    const Vec3 left = left_of(side);
    std::vector<Polygon> parts;
    for (Polygon& part : parts_) {
      if (!runs_through(side, part)) {
        parts.push_back(std::move(part));
        continue;
      }
      for (const Vec3& half : {left, Vec3(-left)}) {
        Polygon cut = clipped(part, half, side.first, touching_);
        if (cut.size() > 2) parts.push_back(std::move(cut));
      }
    }
    parts_ = std::move(parts);
  }
  /// Whether a side is within a part, and not only on its border.
  bool runs_through(const Side& side, const Polygon& part) const {
    double in = 0, out = 1;
    for (std::size_t i = 0; i < part.size(); ++i) {
      const Vec3 inwards = left_of({part[i], part[(i + 1) % part.size()]});
      const double begin = inwards.dot(side.first - part[i]) - touching_;
      const double end = inwards.dot(side.second - part[i]) - touching_;
      if (begin <= 0 && end <= 0) return false;
      if (begin < 0) in = std::max(in, begin / (begin - end));
      if (end < 0) out = std::min(out, begin / (begin - end));
    }
    return (out - in) * (side.second - side.first).norm() > touching_;
  }
  /// By the angle that the outline turns about a point.
  bool holds(const Vec3& point) const {
    double turned = 0;
    for (const Side& side : sides_) {
      const Vec3 a = side.first - point, b = side.second - point;
      turned += std::atan2(normal_.dot(a.cross(b)), a.dot(b));
    }
    return turned > std::numbers::pi;
  }

  Vec3 normal_;
  std::vector<Side> sides_;
  std::vector<Polygon> parts_;
  double area_ = 0, touching_ = 0;
};

}  // namespace

std::vector<Polygon> convex_parts(std::span<const std::array<Vec3, 3>> triangles, const Vec3& normal) {
  if (single_sides(triangles).size() > most_single_sides) return {};
  Polygon whole = convex_outline(triangles, normal);
  if (!whole.empty()) return {std::move(whole)};
  return PieceParts(triangles, normal).find();
}

}  // namespace etendue
