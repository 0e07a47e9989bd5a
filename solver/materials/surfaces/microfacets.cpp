// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/surfaces/microfacets.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/quadrature/panel_rule.h"
#include "base/square.h"

namespace etendue {
namespace {

using std::numbers::pi;

/// Of the disc of visible facets: rings and points on each.
constexpr int rings = 16, facet_turns = 64;
/// At 90 degrees nothing is seen of the facets; the limit is taken from beside it.
constexpr double grazing = 1e-4;

}  // namespace

Microfacets::Microfacets(double reflectance, double roughness, FacetFresnel fresnel)
    : reflectance_(reflectance), roughness_(roughness), fresnel_(fresnel) {
  set_albedo(AlbedoTable([this](double cos_in) { return mean_weight(std::max(cos_in, grazing)); }));
}

double Microfacets::of_facet(double cosine) const {
  if (fresnel_ == FacetFresnel::constant) return reflectance_;
  const double rest = 1 - cosine;
  return reflectance_ + (1 - reflectance_) * square(square(rest)) * rest;
}

double Microfacets::masking(double cosine) const {
  return (std::sqrt(1 + square(roughness_) * (1 / square(cosine) - 1)) - 1) / 2;
}

double Microfacets::value(double cos_in, double cos_out, double between) const {
  // |i + o|^2 = 2 + 2 i.o
  const double cos_facet = std::sqrt(std::max(0.0, (1 + between) / 2));
  if (cos_facet <= 0) return 0;
  const double cos_half = std::min(1.0, (cos_in + cos_out) / (2 * cos_facet));
  const double a = square(roughness_);
  const double slopes = a / (pi * square((a - 1) * square(cos_half) + 1));
  const double shadowing = 1 / (1 + masking(cos_in) + masking(cos_out));
  return of_facet(std::min(1.0, cos_facet)) * slopes * shadowing / (4 * cos_in * cos_out);
}

// Facets as they are seen from i (Heitz 2018): stretched by the roughness the surface is a hemisphere, whose
// outline is a disc in part.
ReflectedRay Microfacets::sample(double cos_in, double u, double v) const {
  const Vec3 light(std::sqrt(std::max(0.0, 1 - square(cos_in))), 0, cos_in);
  const Vec3 stretched = Vec3(roughness_ * light.x(), 0, light.z()).normalized();
  const Vec3 first(0, 1, 0), second = stretched.cross(first);
  const double radius = std::sqrt(u), x = radius * std::cos(2 * pi * v);
  const double upper = (1 + stretched.z()) / 2;
  const double y =
      (1 - upper) * std::sqrt(std::max(0.0, 1 - square(x))) + upper * radius * std::sin(2 * pi * v);
  const double z = std::sqrt(std::max(0.0, 1 - square(x) - square(y)));
  const Vec3 seen = x * first + y * second + z * stretched;
  const Vec3 facet = Vec3(roughness_ * seen.x(), roughness_ * seen.y(), std::max(0.0, seen.z())).normalized();
  const double cos_facet = light.dot(facet);
  const Vec3 out = 2 * cos_facet * facet - light;
  if (out.z() <= 0) return {out, 0};
  const double in_mask = masking(cos_in);
  return {out, of_facet(cos_facet) * (1 + in_mask) / (1 + in_mask + masking(out.z()))};
}

// The mean of the weights over both numbers, with u = sin^2 t: towards its rim the disc is steep.
double Microfacets::mean_weight(double cos_in) const {
  return integral_by_panels(0, pi / 2, rings, [&](double t) {
    const double u = square(std::sin(t));
    double sum = 0;
    for (int i = 0; i < facet_turns; ++i) sum += sample(cos_in, u, (i + 0.5) / facet_turns).weight;
    return std::sin(2 * t) * sum / facet_turns;
  });
}

}  // namespace etendue
