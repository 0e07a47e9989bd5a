// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/surfaces/phong.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/quadrature/panel_rule.h"
#include "solver/materials/surfaces/gaussian_end.h"

namespace etendue {
namespace {

using std::numbers::pi;

constexpr int lobe_panels = 64;

/// The integral of max(a + b cos x, 0) over a full turn; b >= 0.
double positive_turn(double a, double b) {
  if (a >= b) return 2 * pi * a;
  if (a <= -b) return 0;
  const double end = std::acos(-a / b);
  return 2 * (a * end + b * std::sin(end));
}

}  // namespace

Phong::Phong(double reflectance, double exponent) : reflectance_(reflectance), exponent_(exponent) {
  set_albedo(AlbedoTable([this](double cos_in) { return exact_albedo(cos_in); }));
}

double Phong::value(double cos_in, double cos_out, double between) const {
  const double cosine = cosine_off_mirror(cos_in, cos_out, between);
  return cosine > 0 ? reflectance_ * (exponent_ + 2) / (2 * pi) * std::pow(cosine, exponent_) : 0;
}

// Rings about the mirrored direction, each in closed form. With cos^(n+1) a = exp(-x^2) the peak is that of
// exp(-x^2), and the ring that touches the surface parts the interval.
double Phong::exact_albedo(double cos_in) const {
  const double sin_in = std::sqrt(1 - cos_in * cos_in);
  const double power = exponent_ + 1;
  const auto ring = [&](double x) {
    const double z = x * x / power, c = std::exp(-z), s = std::sqrt(-std::expm1(-2 * z));
    return positive_turn(c * cos_in, s * sin_in) * 2 * x * std::exp(-x * x) / power;
  };
  // The ring that touches has a root: x = from + (to - from) y^2 (3 - 2 y) is flat there.
  const auto part = [&](double from, double to) {
    return integral_by_panels(0, 1, lobe_panels, [&](double y) {
      return ring(from + (to - from) * y * y * (3 - 2 * y)) * (to - from) * 6 * y * (1 - y);
    });
  };
  const double touches =
      sin_in > 0 ? std::min(gaussian_end, std::sqrt(-power * std::log(sin_in))) : gaussian_end;
  return reflectance_ * (exponent_ + 2) / (2 * pi) * (part(0, touches) + part(touches, gaussian_end));
}

// Density (n + 1)/(2 pi) cos^n a about the mirrored direction (-sin, 0, cos).
ReflectedRay Phong::sample(double cos_in, double u, double v) const {
  const double c = std::pow(1 - u, 1 / (exponent_ + 1)), s = std::sqrt(std::max(0.0, 1 - c * c));
  const double sin_in = std::sqrt(std::max(0.0, 1 - cos_in * cos_in));
  const Vec3 mirrored(-sin_in, 0, cos_in), across(cos_in, 0, sin_in);
  const Vec3 direction =
      c * mirrored + s * std::cos(2 * pi * v) * across + s * std::sin(2 * pi * v) * Vec3(Vec3::UnitY());
  const double cos_out = direction.z();
  return {direction, cos_out > 0 ? reflectance_ * (exponent_ + 2) / (exponent_ + 1) * cos_out : 0};
}

}  // namespace etendue
