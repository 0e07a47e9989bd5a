// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/lights/point_source.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "solver/lights/lamp_in_cone.h"
#include "solver/problem/lamp_shape.h"

namespace etendue {
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

void PointSource::add_beams(const PointInCell& at, Sight sight, LightDetail, LightBeams& beams) const {
  for (const Image& image : images_) {
    const Vec3 way = image.position - at.position;
    const double distance = way.norm();
    if (distance == 0) continue;
    const double spread = intensity(image, -way / distance) / (distance * distance);
    if (spread == 0) continue;
    const std::span<double> fluence = beams.add(-way / distance);
    std::fill(fluence.begin(), fluence.end(), 1.0);
    if (sight == Sight::attenuated &&
        !paths_.transmit(at, way / distance, distance, image.mirrors, fluence)) {
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
