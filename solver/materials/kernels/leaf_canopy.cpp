// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/kernels/leaf_canopy.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "base/quadrature/unit_rule.h"

namespace etendue {
namespace {

using std::numbers::pi;

constexpr int inclinations = 48, leaf_azimuths = 64;

void add_ring(LeafNormals& leaves, double inclination, double share) {
  for (int j = 0; j < leaf_azimuths; ++j) {
    const double azimuth = 2 * pi * (j + 0.5) / leaf_azimuths;
    leaves.normals.emplace_back(std::sin(inclination) * std::cos(azimuth),
                                std::sin(inclination) * std::sin(azimuth), std::cos(inclination));
    leaves.shares.push_back(share / leaf_azimuths);
  }
}

/// |w.n| in the mean over the azimuth of n (Warren Wilson 1960).
double ring_projection(double inclination, double upward) {
  const double cosines = std::abs(upward) * std::cos(inclination);
  const double sines = std::sqrt(std::max(0.0, 1 - upward * upward)) * std::sin(inclination);
  if (sines <= cosines) return cosines;
  const double turn = std::acos(-cosines / sines);
  return 2 / pi * (cosines * (turn - pi / 2) + sines * std::sin(turn));
}

}  // namespace

double inclination_density(LeafAngles angles, double inclination) {
  switch (angles) {
    case LeafAngles::planophile:
      return 2 / pi * (1 + std::cos(2 * inclination));
    case LeafAngles::erectophile:
      return 2 / pi * (1 - std::cos(2 * inclination));
    case LeafAngles::plagiophile:
      return 2 / pi * (1 - std::cos(4 * inclination));
    case LeafAngles::extremophile:
      return 2 / pi * (1 + std::cos(4 * inclination));
    case LeafAngles::spherical:
      return std::sin(inclination);
    default:
      return 2 / pi;
  }
}

LeafNormals leaf_normals(LeafAngles angles) {
  if (angles == LeafAngles::horizontal) return {{Vec3::UnitZ()}, {1}};
  LeafNormals leaves;
  if (angles == LeafAngles::vertical) {
    add_ring(leaves, pi / 2, 1);
    return leaves;
  }
  const GaussRule rule = unit_rule(inclinations);
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const double inclination = rule.nodes[i] * pi / 2;
    add_ring(leaves, inclination, rule.weights[i] * pi / 2 * inclination_density(angles, inclination));
  }
  return leaves;
}

double leaf_projection(LeafAngles angles, const Vec3& direction) {
  if (angles == LeafAngles::horizontal) return std::abs(direction.z());
  if (angles == LeafAngles::vertical) return ring_projection(pi / 2, direction.z());
  if (angles == LeafAngles::spherical) return 0.5;
  // The projection has a kink where the leaf is seen edge-on: one rule on each side of it.
  const double kink = std::acos(std::sqrt(std::max(0.0, 1 - direction.z() * direction.z())));
  static const GaussRule rule = unit_rule(inclinations);
  double sum = 0;
  for (const auto& [from, to] : {std::pair(0.0, kink), std::pair(kink, pi / 2)})
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      const double inclination = from + rule.nodes[i] * (to - from);
      sum += rule.weights[i] * (to - from) * inclination_density(angles, inclination) *
             ring_projection(inclination, direction.z());
    }
  return sum;
}

double leaf_value(const LeafCanopy& leaves, const LeafNormals& normals, const Vec3& before,
                  const Vec3& after) {
  double sum = 0;
  for (std::size_t i = 0; i < normals.normals.size(); ++i) {
    const double both = before.dot(normals.normals[i]) * after.dot(normals.normals[i]);
    sum += normals.shares[i] * (both > 0 ? leaves.transmittance * both : -leaves.reflectance * both);
  }
  return sum / pi;
}

}  // namespace etendue
