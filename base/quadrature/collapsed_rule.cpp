// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/quadrature/collapsed_rule.h"

#include <array>
#include <cstddef>
#include <vector>

#include "base/quadrature/unit_rule.h"

namespace etendue {
namespace {

constexpr int along_edge = 3, outwards = 6;

template <std::size_t corners>
using Points = std::vector<SimplexPoint<corners>>;

/// Points of the simplex of one to three corners, the others' coordinates zero.
template <std::size_t corners>
Points<corners> smooth_rule(std::bitset<corners> set) {
  std::vector<std::size_t> of;
  for (std::size_t i = 0; i < corners; ++i)
    if (set[i]) of.push_back(i);
  Points<corners> points;
  if (of.size() == 1) {
    points.push_back({{}, 1});
    points[0].barycentric[of[0]] = 1;
  } else if (of.size() == 2) {
    const GaussRule rule = unit_rule(along_edge);
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      points.push_back({{}, rule.weights[i]});
      points[i].barycentric[of[0]] = 1 - rule.nodes[i];
      points[i].barycentric[of[1]] = rule.nodes[i];
    }
  } else {
    for (const FacePointWeight& point : seven_point_rule()) {
      points.push_back({{}, point.weight});
      for (std::size_t k = 0; k < 3; ++k) points.back().barycentric[of[k]] = point.barycentric[k];
    }
  }
  return points;
}

double whole_power(double x, std::size_t n) { return n == 0 ? 1 : x * whole_power(x, n - 1); }
double factorial(std::size_t n) { return n == 0 ? 1 : static_cast<double>(n) * factorial(n - 1); }

/// Points between those of T, a simplex of k corners, and those of O, one of m: of the volume dx is
/// s^(m-1) (1-s)^(k-1) (k+m-1)! / ((k-1)! (m-1)!) dy dz ds.
template <std::size_t corners>
Points<corners> between(const Points<corners>& of_t, std::size_t k, const Points<corners>& of_o,
                        std::size_t m) {
  const GaussRule rule = unit_rule(outwards);
  Points<corners> points;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const double t = rule.nodes[i], s = t * t;
    const double density = 2 * t * whole_power(s, m - 1) * whole_power(1 - s, k - 1) * factorial(k + m - 1) /
                           (factorial(k - 1) * factorial(m - 1));
    for (const auto& y : of_t)
      for (const auto& z : of_o) {
        points.push_back({{}, rule.weights[i] * density * y.weight * z.weight});
        for (std::size_t c = 0; c < corners; ++c)
          points.back().barycentric[c] = (1 - s) * y.barycentric[c] + s * z.barycentric[c];
      }
  }
  return points;
}

/// Points of the simplex of these corners, collapsed towards those of them that are in a set.
template <std::size_t corners>
Points<corners> towards(std::bitset<corners> set, std::bitset<corners> of) {
  const std::bitset<corners> near = of & set, away = of & ~set;
  if (near.none() || away.none()) return smooth_rule(of);
  return between(smooth_rule(near), near.count(), smooth_rule(away), away.count());
}

template <std::size_t corners>
Points<corners> collapsed_corners_rule(const SteepCorners<corners>& steep) {
  const std::bitset<corners> all = std::bitset<corners>().set();
  const std::bitset<corners> near = steep.rim.any() ? steep.rim : steep.surface, away = all & ~near;
  if (near.none() || away.none()) return {};
  return between(smooth_rule(near), near.count(), towards(steep.surface, away), away.count());
}

}  // namespace

template <std::size_t corners>
std::span<const SimplexPoint<corners>> collapsed_rule(const SteepCorners<corners>& steep) {
  constexpr std::size_t sets = std::size_t{1} << corners;
  static const auto rules = [] {
    std::array<Points<corners>, sets * sets> made;
    for (std::size_t i = 0; i < made.size(); ++i)
      made[i] = collapsed_corners_rule<corners>({i / sets, i % sets});
    return made;
  }();
  return rules[steep.surface.to_ulong() * sets + steep.rim.to_ulong()];
}

template std::span<const SimplexPoint<3>> collapsed_rule(const SteepCorners<3>& steep);
template std::span<const SimplexPoint<4>> collapsed_rule(const SteepCorners<4>& steep);

}  // namespace etendue
