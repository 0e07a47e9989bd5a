// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/fibre.h"

#include <cmath>
#include <numbers>

namespace etendue {
namespace {

constexpr int fibre_directions = 128;
/// The golden angle [rad]: pi (3 - sqrt 5).
constexpr double between = std::numbers::pi * 0.7639320225002103;

/// The part of the beam that leaves the tip in a direction: its cross-section is that of the tip as seen from
/// there, its irradiance that part of the beam's power over it.
BeamLight part_along(const BeamLight& beam, const Vec3& direction) {
  const double cosine = direction.dot(beam.direction);
  BeamLight part = beam;
  part.direction = direction;
  for (Vec3* axis : {&part.profile->across, &part.profile->upright})
    *axis -= axis->dot(direction) / cosine * beam.direction;
  for (double& irradiance : part.irradiance) irradiance /= fibre_directions * cosine;
  return part;
}

}  // namespace

std::vector<BeamLight> fibre_parts(const BeamLight& beam, double numerical_aperture) {
  std::vector<BeamLight> parts;
  const Vec3 u = beam.direction.unitOrthogonal(), v = beam.direction.cross(u);
  for (int i = 0; i < fibre_directions; ++i) {
    const double sine = numerical_aperture * std::sqrt((i + 0.5) / fibre_directions), azimuth = i * between;
    parts.push_back(part_along(beam, sine * (std::cos(azimuth) * u + std::sin(azimuth) * v) +
                                         std::sqrt(1 - sine * sine) * beam.direction));
  }
  return parts;
}

}  // namespace etendue
