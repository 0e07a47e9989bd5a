// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/solver/radiosity/form_factors/hemicube.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace etendue {
namespace {

constexpr std::size_t sides = 5;
constexpr double nothing = std::numeric_limits<double>::infinity();

/// A side looks along the third axis; pixels lie along the first and second. On the four walls the second is
/// the normal of the element, and only its positive half is there.
struct SideAxes {
  std::array<int, 3> axis;
  double sign;
};
constexpr std::array<SideAxes, sides> side_axes = {
    {{{0, 1, 2}, 1}, {{1, 2, 0}, 1}, {{1, 2, 0}, -1}, {{0, 2, 1}, 1}, {{0, 2, 1}, -1}}};

Vec3 seen_from(std::size_t side, const Vec3& point) {
  const SideAxes& axes = side_axes[side];
  return {point[axes.axis[0]], point[axes.axis[1]], axes.sign * point[axes.axis[2]]};
}

/// Pixels of a side in [first, last) around the projection of a triangle; all where a corner is not before
/// it.
struct PixelRange {
  int first, last;
};
PixelRange range_of(const std::array<Vec3, 3>& corners, int axis, double begin, double size, int count) {
  double low = nothing, high = -nothing;
  for (const Vec3& corner : corners) {
    if (corner[2] <= 0) return {0, count};
    low = std::min(low, corner[axis] / corner[2]);
    high = std::max(high, corner[axis] / corner[2]);
  }
  const auto pixel = [&](double place) { return std::clamp((place - begin) / size, 0.0, 1.0 * count); };
  return {static_cast<int>(std::floor(pixel(low))), static_cast<int>(std::ceil(pixel(high)))};
}

/// Keeps the pixels where value + pixel step >= 0.
void narrow(PixelRange& range, double value, double step) {
  const auto bound = [&](double pixel) {
    return static_cast<int>(std::clamp(pixel, -1.0 + range.first, 1.0 + range.last));
  };
  if (step > 0)
    range.first = std::max(range.first, bound(std::ceil(-value / step)));
  else if (step < 0)
    range.last = std::min(range.last, bound(std::floor(-value / step)) + 1);
  else if (value < 0)
    range.last = range.first;
}

}  // namespace

Hemicube::Hemicube(int pixels) : pixels_(pixels), weights_(sides), depths_(sides), groups_(sides) {
  const double size = 2.0 / pixels;
  double sum = 0;
  for (std::size_t side = 0; side < sides; ++side)
    for (int row = 0; row < (side == 0 ? pixels : pixels / 2); ++row)
      for (int column = 0; column < pixels; ++column) {
        const double u = -1 + (column + 0.5) * size, v = (side == 0 ? -1 : 0) + (row + 0.5) * size;
        const double square = u * u + v * v + 1;
        const double height = side == 0 ? 1 : v;
        weights_[side].push_back(height * size * size / (std::numbers::pi * square * square));
        sum += weights_[side].back();
      }
  for (std::vector<double>& side : weights_)
    for (double& weight : side) weight /= sum;
}

// A pixel's direction (u, v, 1) lies inside of the cone of the corners a, b, c where a x b, b x c and c x a
// are on the same side of it, and meets the plane at det(a, b, c) over their sum (Olano and Greer 1997):
// nothing need be clipped.
void Hemicube::draw(std::size_t side, const std::array<Vec3, 3>& corners, std::size_t group) {
  const double size = 2.0 / pixels_, begin_v = side == 0 ? -1 : 0;
  const int rows = side == 0 ? pixels_ : pixels_ / 2;
  const PixelRange columns = range_of(corners, 0, -1, size, pixels_);
  const PixelRange lines = range_of(corners, 1, begin_v, size, rows);
  const std::array<Vec3, 3> edges = {corners[1].cross(corners[2]), corners[2].cross(corners[0]),
                                     corners[0].cross(corners[1])};
  const double determinant = corners[0].dot(edges[0]);
  const double turn = determinant < 0 ? -1 : 1;
  for (int row = lines.first; row < lines.last; ++row) {
    const Vec3 begin(-1 + 0.5 * size, begin_v + (row + 0.5) * size, 1);
    std::array<double, 3> value, step;
    PixelRange inside = columns;
    for (std::size_t i = 0; i < 3; ++i) {
      value[i] = turn * edges[i].dot(begin);
      step[i] = turn * edges[i][0] * size;
      narrow(inside, value[i], step[i]);
    }
    for (int column = inside.first; column < inside.last; ++column) {
      const double sum = value[0] + value[1] + value[2] + column * (step[0] + step[1] + step[2]);
      const auto pixel = static_cast<std::size_t>(row * pixels_ + column);
      // Where the sum is zero the plane is not met.
      if (!(std::abs(determinant) < depths_[side][pixel] * sum)) continue;
      depths_[side][pixel] = std::abs(determinant) / sum;
      groups_[side][pixel] = group;
    }
  }
}

std::vector<double> Hemicube::factors(const Vec3& point, const Vec3& normal, double angle,
                                      const std::vector<TriangleCorners>& triangles,
                                      const std::vector<std::size_t>& group_of, std::size_t groups) {
  for (std::size_t side = 0; side < sides; ++side) {
    depths_[side].assign(weights_[side].size(), nothing);
    groups_[side].assign(weights_[side].size(), groups);
  }
  const Vec3 first = normal.unitOrthogonal();
  const Vec3 along = std::cos(angle) * first + std::sin(angle) * normal.cross(first),
             up = normal.cross(along);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    std::array<Vec3, 3> local;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 separation = triangles[t][i] - point;
      local[i] = {separation.dot(along), separation.dot(up), separation.dot(normal)};
    }
    const Vec3 front = (local[1] - local[0]).cross(local[2] - local[0]);
    if (front.dot(local[0]) >= 0 || std::max({local[0][2], local[1][2], local[2][2]}) <= 0) continue;
    for (std::size_t side = 0; side < sides; ++side) {
      const std::array<Vec3, 3> seen = {seen_from(side, local[0]), seen_from(side, local[1]),
                                        seen_from(side, local[2])};
      if (std::max({seen[0][2], seen[1][2], seen[2][2]}) > 0) draw(side, seen, group_of[t]);
    }
  }
  std::vector<double> factors(groups + 1, 0);
  for (std::size_t side = 0; side < sides; ++side)
    for (std::size_t pixel = 0; pixel < weights_[side].size(); ++pixel)
      factors[groups_[side][pixel]] += weights_[side][pixel];
  factors.pop_back();
  return factors;
}

namespace {

double area_of(const TriangleCorners& t) { return (t[1] - t[0]).cross(t[2] - t[0]).norm() / 2; }

void append_parts(const TriangleCorners& t, double largest, std::vector<TriangleCorners>& parts) {
  if (area_of(t) <= largest) {
    parts.push_back(t);
    return;
  }
  std::size_t longest = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if ((t[(i + 1) % 3] - t[i]).squaredNorm() > (t[(longest + 1) % 3] - t[longest]).squaredNorm())
      longest = i;
  const Vec3 &a = t[longest], &b = t[(longest + 1) % 3], &c = t[(longest + 2) % 3];
  const Vec3 middle = (a + b) / 2;
  append_parts({a, middle, c}, largest, parts);
  append_parts({middle, b, c}, largest, parts);
}

}  // namespace

std::vector<double> factors_by_hemicube(const std::vector<TriangleCorners>& from, int parts,
                                        Hemicube& hemicube, const std::vector<TriangleCorners>& triangles,
                                        const std::vector<std::size_t>& group_of, std::size_t groups) {
  // The golden ratio's turns are spread most evenly.
  const double turn = std::numbers::pi * (std::sqrt(5.0) - 1);
  double area = 0;
  for (const TriangleCorners& t : from) area += area_of(t);
  std::vector<TriangleCorners> pieces;
  for (const TriangleCorners& t : from) append_parts(t, area / parts, pieces);
  std::vector<double> sum(groups, 0);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const TriangleCorners& t = pieces[i];
    const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
    const std::vector<double> factors =
        hemicube.factors((t[0] + t[1] + t[2]) / 3, normal.normalized(), turn * static_cast<double>(i),
                         triangles, group_of, groups);
    for (std::size_t g = 0; g < groups; ++g) sum[g] += area_of(t) / area * factors[g];
  }
  return sum;
}

}  // namespace etendue
