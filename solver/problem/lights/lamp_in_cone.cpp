// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/problem/lights/lamp_in_cone.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/quadrature/gauss_legendre.h"
#include "solver/problem/lights/lamp_shape.h"

namespace etendue {
namespace {

using std::numbers::pi;

/// Nodes between two angles at which the integrand bends. Beside them it may go like a square root, which is
/// smooth in the angle that cosines are taken of below.
constexpr int nodes = 24;

/// A half space of directions, in the lamp's polar coordinates (t, phi): a cos t + b sin t cos(phi - c) >= 0.
struct HalfSpace {
  double along;    ///< a
  double across;   ///< b, not negative
  double azimuth;  ///< c

  bool holds(double t, double phi) const {
    return along * std::cos(t) + across * std::sin(t) * std::cos(phi - azimuth) >= 0;
  }
};

/// Frame of the lamp's angles. A lamp that is the same all about its axis says nothing of the other two.
struct Frame {
  Vec3 axis, zero, quarter;

  explicit Frame(const PointLight& light)
      : axis(light.axis), zero(light.zero_plane), quarter(light.quarter_plane) {
    if (!light.plane.empty()) return;
    zero = axis.unitOrthogonal();
    quarter = axis.cross(zero);
  }
  HalfSpace half_space(const Vec3& normal) const {
    const double x = normal.dot(zero), y = normal.dot(quarter);
    return {normal.dot(axis), std::hypot(x, y), std::atan2(y, x)};
  }
  double angle(const Vec3& direction) const {
    return std::atan2(axis.cross(direction).norm(), axis.dot(direction));
  }
};

/// Angles t at which the integral over the azimuth bends: those of the lamp's table, those at which a circle
/// about the axis begins or ends to meet a plane, and those of the edges between planes.
std::vector<double> bends(const PointLight& light, const Frame& frame, const TangentCone::Part& part) {
  std::vector<double> angles = light.angle;
  for (std::size_t i = 0; i < part.size(); ++i) {
    const double to_plane = std::abs(pi / 2 - frame.angle(part[i]));
    angles.insert(angles.end(), {to_plane, pi - to_plane});
    for (std::size_t j = 0; j < i; ++j) {
      const double edge = frame.angle(part[i].cross(part[j]));
      angles.insert(angles.end(), {edge, pi - edge});
    }
  }
  for (double& angle : angles) angle = std::clamp(angle, light.angle.front(), light.angle.back());
  std::ranges::sort(angles);
  return angles;
}

/// Azimuths in one turn at which the shape bends or a half space ends, on the circle at the angle t.
std::vector<double> azimuth_bends(const PointLight& light, const std::vector<HalfSpace>& half_spaces,
                                  double t) {
  std::vector<double> azimuths = light.plane;
  for (const HalfSpace& half : half_spaces) {
    const double cosine = -half.along * std::cos(t) / (half.across * std::sin(t));
    if (!(std::abs(cosine) < 1)) continue;
    azimuths.push_back(half.azimuth - std::acos(cosine));
    azimuths.push_back(half.azimuth + std::acos(cosine));
  }
  for (double& azimuth : azimuths) azimuth -= 2 * pi * std::floor(azimuth / (2 * pi));
  azimuths.insert(azimuths.end(), {0.0, 2 * pi});
  std::ranges::sort(azimuths);
  return azimuths;
}

/// The integral over the azimuth at the angle t. Between its bends the shape is linear.
double about_axis(const PointLight& light, const std::vector<HalfSpace>& half_spaces, double t) {
  const std::vector<double> azimuths = azimuth_bends(light, half_spaces, t);
  double sum = 0;
  for (std::size_t i = 1; i < azimuths.size(); ++i) {
    const double middle = (azimuths[i - 1] + azimuths[i]) / 2;
    if (std::ranges::all_of(half_spaces, [&](const HalfSpace& half) { return half.holds(t, middle); }))
      sum += (azimuths[i] - azimuths[i - 1]) * lamp_shape(light, t, middle);
  }
  return sum;
}

double integral_over(const PointLight& light, const Frame& frame, const TangentCone::Part& part) {
  static const GaussRule rule = gauss_legendre(nodes);
  std::vector<HalfSpace> half_spaces;
  for (const Vec3& normal : part) half_spaces.push_back(frame.half_space(normal));
  const std::vector<double> angles = bends(light, frame, part);
  double sum = 0;
  for (std::size_t i = 1; i < angles.size(); ++i) {
    // t = middle - half cos(theta), theta from 0 to pi.
    const double middle = (angles[i] + angles[i - 1]) / 2, half = (angles[i] - angles[i - 1]) / 2;
    for (std::size_t n = 0; n < rule.nodes.size() && half > 0; ++n) {
      const double theta = pi / 2 * (1 + rule.nodes[n]), t = middle - half * std::cos(theta);
      sum +=
          pi / 2 * rule.weights[n] * half * std::sin(theta) * std::sin(t) * about_axis(light, half_spaces, t);
    }
  }
  return sum;
}

}  // namespace

double integral_of_lamp_shape(const PointLight& light, const TangentCone& cone) {
  if (cone.is_whole()) return integral_of_lamp_shape(light);
  if (light.angle.empty()) return cone.solid_angle();
  const Frame frame(light);
  double sum = 0;
  for (const TangentCone::Part& part : cone.parts()) sum += integral_over(light, frame, part);
  return sum;
}

}  // namespace etendue
