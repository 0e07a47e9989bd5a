// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/photons/sampling/direction_sampler.h"

#include <cmath>
#include <numbers>

#include "solver/materials/kernels/leaf_canopy.h"
#include "solver/photons/kernel/photon_turns.h"

namespace etendue {
namespace {

using std::numbers::pi;

// No inclination of leaves is denser than this.
constexpr double densest_inclination = 4 / pi;

Vec3 lambert_about(const Vec3& normal, DrawnNumbers& random) {
  double c, s, w[3] = {normal.x(), normal.y(), normal.z()};
  unit_circle(random.word(), c, s);
  turn(w, std::sqrt(random.number()), c, s);
  return {w[0], w[1], w[2]};
}

class LeafSampler : public DirectionSampler {
 public:
  explicit LeafSampler(const LeafCanopy& leaves) : leaves_(leaves) {}

  Vec3 scattered(CellIndex, const Vec3& travel, DrawnNumbers& random) const override {
    Vec3 ahead = normal_met(travel, random);
    if (ahead.dot(travel) < 0) ahead = -ahead;
    const bool through =
        random.number() * (leaves_.reflectance + leaves_.transmittance) < leaves_.transmittance;
    return lambert_about(through ? ahead : Vec3(-ahead), random);
  }

 private:
  Vec3 normal_met(const Vec3& travel, DrawnNumbers& random) const {
    if (leaves_.angles == LeafAngles::horizontal) return Vec3::UnitZ();
    if (leaves_.angles == LeafAngles::vertical) return upright_normal(travel, random);
    while (true) {
      const double inclination = random.number() * pi / 2;
      if (random.number() * densest_inclination >= inclination_density(leaves_.angles, inclination)) continue;
      double c, s;
      unit_circle(random.word(), c, s);
      const Vec3 normal(std::sin(inclination) * c, std::sin(inclination) * s, std::cos(inclination));
      if (random.number() < std::abs(travel.dot(normal))) return normal;
    }
  }

  /// Light along z meets none, and light close to it few: the slope cancels.
  static Vec3 upright_normal(const Vec3& travel, DrawnNumbers& random) {
    const double level = std::hypot(travel.x(), travel.y());
    const Vec3 along = level > 0 ? Vec3(travel.x() / level, travel.y() / level, 0) : Vec3(Vec3::UnitX());
    double c, s;
    do unit_circle(random.word(), c, s);
    while (random.number() >= std::abs(c));
    return c * along + s * Vec3(-along.y(), along.x(), 0);
  }

  LeafCanopy leaves_;
};

class FlakeSampler : public DirectionSampler {
 public:
  explicit FlakeSampler(const MicroFlakes& flakes) : flakes_(flakes) {}

  Vec3 scattered(CellIndex, const Vec3& travel, DrawnNumbers& random) const override {
    const Vec3 normal = stretched(lambert_about(stretched(travel), random));
    return (travel - 2 * travel.dot(normal) * normal).normalized();
  }

 private:
  /// C v, as a unit vector.
  Vec3 stretched(const Vec3& v) const {
    const Vec3 along = flakes_.axis.dot(v) * flakes_.axis;
    return (flakes_.along * along + flakes_.across * (v - along)).normalized();
  }

  MicroFlakes flakes_;
};

}  // namespace

std::unique_ptr<DirectionSampler> make_direction_sampler(const DirectionalScattering& scattering) {
  if (const auto* leaves = std::get_if<LeafCanopy>(&scattering))
    return std::make_unique<LeafSampler>(*leaves);
  if (const auto* flakes = std::get_if<MicroFlakes>(&scattering))
    return std::make_unique<FlakeSampler>(*flakes);
  return nullptr;
}

}  // namespace etendue
