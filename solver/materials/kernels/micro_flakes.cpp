// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/kernels/micro_flakes.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "base/quadrature/unit_rule.h"

namespace etendue {
namespace {

using std::numbers::pi;

constexpr int flake_nodes = 96;

/// The integral over phi of 1/(alpha^2 + beta^2 (p + q cos phi)^2), in partial fractions that are known each.
double ring(double alpha, std::complex<double> beta, double p, double q) {
  const std::complex<double> turned = std::complex<double>(0, 1) * beta, beta_squared = beta * beta * q * q;
  const std::complex<double> a = alpha + turned * p, b = alpha - turned * p;
  return pi / alpha * (1.0 / std::sqrt(a * a + beta_squared) + 1.0 / std::sqrt(b * b + beta_squared)).real();
}

}  // namespace

double flake_projection(const MicroFlakes& flakes, const Vec3& direction) {
  const double cosine = flakes.axis.dot(direction);
  return std::sqrt(flakes.across * flakes.across +
                   (flakes.along * flakes.along - flakes.across * flakes.across) * cosine * cosine);
}

double mean_flake_projection(const MicroFlakes& flakes) {
  const GaussRule rule = unit_rule(flake_nodes);
  double sum = 0;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const double cosine = rule.nodes[i];
    const double sine = std::sqrt(1 - cosine * cosine);
    sum += rule.weights[i] *
           flake_projection(flakes, cosine * flakes.axis + sine * flakes.axis.unitOrthogonal());
  }
  return sum;
}

double flake_momentum_transfer(const MicroFlakes& flakes, const Vec3& direction) {
  // Off a mirror 1 - w.v = 2 (w.h)^2 and dv = 4 |w.h| dh: the integral of D(h) |w.h|^3 over the sphere.
  // Flakes are the normals h = C u/|C u| of an ellipsoid, C^2 = S, of area |C u| du/pi. With s t = C w, |t| =
  // 1, and c = u.t the rings about t are known, and 2 s^3/pi times the integral of c^3 ring(c) remains.
  static const GaussRule rule = unit_rule(flake_nodes);
  const double along = flakes.along, across = flakes.across, cosine = flakes.axis.dot(direction);
  const double size = flake_projection(flakes, direction);
  const double near = std::min(1.0, std::abs(along * cosine) / size);
  const double far = std::sqrt(1 - near * near);
  const std::complex<double> beta = std::sqrt(std::complex<double>((along - across) * (along + across)));
  // Where a ring first meets the faces of thin flakes, or the ends of thin fibres, it has a peak: nodes are
  // dense on both sides.
  const double peak = along > across ? far : near;
  double sum = 0;
  for (const double end : {0.0, 1.0})
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      const double t = rule.nodes[i], c = peak + (end - peak) * t * t;
      const double q = std::sqrt(1 - c * c) * far;
      sum += rule.weights[i] * 2 * t * std::abs(end - peak) * c * c * c * ring(across, beta, c * near, q);
    }
  return 2 * size * size * size / pi * sum;
}

double flake_value(const MicroFlakes& flakes, const Vec3& before, const Vec3& after) {
  const double along = flakes.along * flakes.along, across = flakes.across * flakes.across;
  const double root = flakes.along * flakes.across * flakes.across;
  const double cosine = flakes.axis.dot((after - before).normalized());
  const double stretched = cosine * cosine / along + (1 - cosine * cosine) / across;
  return flakes.albedo / (4 * std::numbers::pi * root * stretched * stretched);
}

}  // namespace etendue
