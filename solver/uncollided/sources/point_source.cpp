// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/sources/point_source.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "solver/problem/lights/lamp_in_cone.h"
#include "solver/problem/lights/lamp_shape.h"

namespace etendue {
namespace {

/// Chords of a cone's edge: 4e-4 of its width lie between each and the arc.
constexpr int chords = 96;

/// Polar angle of the corners of a regular polygon on the unit sphere with as much solid angle as a cone: its
/// triangles about the axis have base angles pi / 2 - (pi / n) cos(angle) (Girard 1629).
double angle_of_corners(double angle) {
  const double half = std::numbers::pi / chords;
  return std::acos(std::tan(half * std::cos(angle)) / std::tan(half));
}

}  // namespace

PointSource::PointSource(std::string name, const PointLight& light, TangentCone cone, const LightPaths& paths)
    : LightSource(std::move(name), light.power),
      light_(light),
      cone_(std::move(cone)),
      paths_(paths),
      norm_(integral_of_lamp_shape(light, cone_)) {
  for (const MirrorSet mirrors : paths.mirrors().images_of_point())
    images_.push_back({paths.mirrors().image(mirrors, light.position), mirrors});
}

double PointSource::intensity(const Image& image, const Vec3& direction) const {
  if (light_.angle.empty() && cone_.is_whole()) return 1 / norm_;
  const Vec3 sent = paths_.mirrors().image_direction(image.mirrors, direction);
  return cone_.contains(sent) ? lamp_shape(light_, sent) / norm_ : 0;
}

std::vector<std::vector<Vec3>> PointSource::rims(const Image& image) const {
  std::vector<std::vector<Vec3>> rims;
  const Vec3 across = light_.axis.unitOrthogonal(), third = light_.axis.cross(across);
  for (const double edge : edges_of_lamp_shape(light_)) {
    const double polar = angle_of_corners(edge);
    std::vector<Vec3>& rim = rims.emplace_back();
    for (int i = 0; i < chords; ++i) {
      const double azimuth = 2 * std::numbers::pi * i / chords;
      const Vec3 sent = std::cos(polar) * light_.axis +
                        std::sin(polar) * (std::cos(azimuth) * across + std::sin(azimuth) * third);
      rim.push_back(paths_.mirrors().image_direction(image.mirrors, sent));
    }
  }
  return rims;
}

void PointSource::add_beams(const PointInCell& at, Sight sight, LightDetail, LightBeams& beams) const {
  for (const Image& image : images_) {
    const Vec3 separation = image.position - at.position;
    const double distance = separation.norm();
    if (distance == 0) continue;
    const double spread = intensity(image, -separation / distance) / (distance * distance);
    if (spread == 0) continue;
    const std::span<double> fluence = beams.add(-separation / distance);
    std::fill(fluence.begin(), fluence.end(), 1.0);
    if (sight == Sight::attenuated &&
        !paths_.transmit(at, separation / distance, distance, image.mirrors, fluence)) {
      beams.drop();
      continue;
    }
    for (std::size_t b = 0; b < fluence.size(); ++b) fluence[b] *= power()[b] * spread;
  }
}

bool PointSource::is_near(const Vec3& place, double size) const {
  constexpr double near = 3;
  return std::any_of(images_.begin(), images_.end(), [&](const Image& image) {
    return (image.position - place).squaredNorm() < near * near * size * size;
  });
}

}  // namespace etendue
