// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/build/sky_parts.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "app/case/point_light.h"
#include "solver/problem/lights/lamp_shape.h"

namespace etendue {
namespace {

using std::numbers::pi;

/// Parts of a sky are about as wide as that [rad]: a sun in it is a light of its own.
constexpr double width_of_part = 10 * pi / 180;

}  // namespace

// Rings about the zenith, each cut into parts, as many in each quarter, that stand at its mean cosine: a
// level plane gets from them exactly what an even sky sends. Their brightness is a mean over 3 x 3 points.
// The table counts azimuths counterclockwise seen from above.
std::vector<BeamLight> sky_parts(const LightCase& light, const std::vector<int>& walls) {
  PointLight table = point_light(light);
  table.axis = -light.direction;
  std::vector<BeamLight> sky;
  double level = 0;  // irradiance of a level plane, of radiance 1
  const auto rings = static_cast<int>(std::ceil(table.angle.back() / width_of_part));
  // A dark ring below the last one says where the sky ends.
  for (int ring = 0; ring <= rings; ++ring) {
    const double upper = std::cos(table.angle.back() * ring / rings),
                 lower = std::cos(std::min(pi, table.angle.back() * (ring + 1) / rings));
    if (upper - lower <= 0) break;
    const double cosine = (upper + lower) / 2, sine = std::sqrt(1 - cosine * cosine);
    const int count = 4 * static_cast<int>(std::ceil(2 * pi * sine / (4 * width_of_part)));
    for (int i = 0; i < count; ++i) {
      const auto azimuth = [&](double place) { return 2 * pi * (i + place) / count; };
      double brightness = 0;
      for (const double a : {1. / 6, 0.5, 5. / 6})
        for (const double b : {1. / 6, 0.5, 5. / 6})
          if (ring < rings)
            brightness += lamp_shape(table, std::acos(upper + a * (lower - upper)), azimuth(b)) / 9;
      const Vec3 from = cosine * table.axis + sine * (std::cos(azimuth(0.5)) * table.zero_plane +
                                                      std::sin(azimuth(0.5)) * table.quarter_plane);
      BeamLight beam{-from, values_of(light.strength), walls, 2 * pi * (upper - lower) / count};
      for (double& irradiance : beam.irradiance) irradiance *= beam.solid_angle * brightness;
      level += beam.solid_angle * brightness * cosine;
      sky.push_back(std::move(beam));
    }
  }
  if (std::holds_alternative<IrradianceOfLight>(light.strength))
    for (BeamLight& part : sky)
      for (double& irradiance : part.irradiance) irradiance /= level;
  return sky;
}

std::vector<BeamLight> even_sky_parts(const LightCase& light, const Vec3& inwards,
                                      const std::vector<int>& walls) {
  LightCase half = light;
  half.direction = inwards;
  half.along = inwards.unitOrthogonal();
  half.angle = {0, 90};
  half.intensity = {1, 1};
  half.plane.clear();
  half.type = PhotometricType::c;
  // Before the wall the rings get the same irradiance of it as a level plane of a whole sky.
  return sky_parts(half, walls);
}

}  // namespace etendue
