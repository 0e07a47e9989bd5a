// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/problem/lights/lamp_shape.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <span>

namespace etendue {
namespace {

using std::numbers::pi;

/// A bend is sharp where the slopes on its sides differ by this part of the largest intensity per radian.
constexpr double sharp_bend = 0.3;
constexpr std::size_t most_edges = 4;

/// A place between two of the values given: index of the second, and the fraction of the distance to it.
struct Between {
  std::size_t next = 0;
  double part = 0;
};

/// Next 0 where the value is beyond those given.
Between find(std::span<const double> given, double value) {
  if (value < given.front() || value > given.back()) return {};
  const auto next = std::upper_bound(given.begin() + 1, given.end() - 1, value);
  const double width = next[0] - next[-1];  // 0 at a sharp edge
  return {static_cast<std::size_t>(next - given.begin()), width > 0 ? (value - next[-1]) / width : 1};
}

double value_at(std::span<const double> values, const Between& at) {
  return values[at.next - 1] + at.part * (values[at.next] - values[at.next - 1]);
}

std::span<const double> values_of_plane(const PointLight& light, std::size_t plane) {
  return std::span(light.intensity).subspan(plane * light.angle.size(), light.angle.size());
}

}  // namespace

double lamp_shape(const PointLight& light, double angle, double azimuth) {
  if (light.angle.empty()) return 1;
  const Between at_angle = find(light.angle, angle);
  if (at_angle.next == 0) return 0;
  if (light.plane.empty()) return value_at(light.intensity, at_angle);
  while (azimuth < light.plane.front()) azimuth += 2 * pi;
  while (azimuth > light.plane.front() + 2 * pi) azimuth -= 2 * pi;
  const Between at_plane = find(light.plane, azimuth);
  if (at_plane.next == 0) return 0;
  const double before = value_at(values_of_plane(light, at_plane.next - 1), at_angle);
  return before + at_plane.part * (value_at(values_of_plane(light, at_plane.next), at_angle) - before);
}

double lamp_shape(const PointLight& light, const Vec3& direction) {
  if (light.angle.empty()) return 1;
  const double angle = std::atan2(light.axis.cross(direction).norm(), light.axis.dot(direction));
  if (light.plane.empty()) return lamp_shape(light, angle, 0);
  // On the axis 0, where a sum of negative zeros would make it pi.
  const double across = direction.dot(light.quarter_plane) + 0.0,
               ahead = direction.dot(light.zero_plane) + 0.0;
  return lamp_shape(light, angle, std::atan2(across, ahead));
}

std::vector<double> lamp_shape_about_axis(const PointLight& light) {
  std::vector<double> sum(light.angle.size(), 0);
  if (light.plane.empty()) {
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = 2 * pi * light.intensity[i];
    return sum;
  }
  for (std::size_t plane = 1; plane < light.plane.size(); ++plane)
    for (std::size_t i = 0; i < sum.size(); ++i)
      sum[i] += (light.plane[plane] - light.plane[plane - 1]) / 2 *
                (values_of_plane(light, plane - 1)[i] + values_of_plane(light, plane)[i]);
  return sum;
}

// Closed for each linear piece: with i = a + b t, the integral of (a + b t) sin t is -(a + b t) cos t + b sin
// t.
double integral_of_lamp_shape(const PointLight& light) {
  if (light.angle.empty()) return 4 * pi;
  const std::vector<double> about_axis = lamp_shape_about_axis(light);
  double sum = 0;
  for (std::size_t i = 1; i < light.angle.size(); ++i) {
    const double t0 = light.angle[i - 1], t1 = light.angle[i];
    if (t1 <= t0) continue;
    const double slope = (about_axis[i] - about_axis[i - 1]) / (t1 - t0);
    sum += about_axis[i - 1] * std::cos(t0) - about_axis[i] * std::cos(t1) +
           slope * (std::sin(t1) - std::sin(t0));
  }
  return sum;
}

std::vector<double> edges_of_lamp_shape(const PointLight& light) {
  struct Edge {
    double angle, bend;
  };
  const std::vector<double>& angle = light.angle;
  std::vector<Edge> edges;
  const double most = light.intensity.empty() ? 0 : std::ranges::max(light.intensity);
  for (std::size_t i = 0; i < angle.size(); ++i) {
    if (angle[i] <= 0 || angle[i] >= pi) continue;
    double bend = 0;
    for (std::size_t plane = 0; plane < std::max<std::size_t>(1, light.plane.size()); ++plane) {
      const std::span<const double> values = values_of_plane(light, plane);
      const auto slope = [&](std::size_t k) {
        return (values[k] - values[k - 1]) / (angle[k] - angle[k - 1]);
      };
      const bool first = i == 0, last = i + 1 == angle.size();
      const double before = first ? 0 : slope(i), after = last ? 0 : slope(i + 1);
      const bool jumps = (first || last) && values[i] > 0;
      if (jumps || std::isinf(before) || std::isinf(after))
        bend = std::numeric_limits<double>::infinity();
      else
        bend = std::max(bend, std::abs(after - before));
    }
    if (bend > sharp_bend * most && (edges.empty() || edges.back().angle < angle[i]))
      edges.push_back({angle[i], bend});
  }
  std::ranges::stable_sort(edges, std::ranges::greater(), &Edge::bend);
  edges.resize(std::min(edges.size(), most_edges));
  std::vector<double> angles;
  for (const Edge& edge : edges) angles.push_back(edge.angle);
  std::ranges::sort(angles);
  return angles;
}

}  // namespace etendue
