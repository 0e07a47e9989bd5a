// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/lights/point_source.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace etendue {
namespace {

using std::numbers::pi;

/// The shape at an angle; 1 without a table.
double shape_at(const PointLight& light, double angle) {
  if (light.angle.empty()) return 1;
  const auto next = std::upper_bound(light.angle.begin(), light.angle.end(), angle);
  if (next == light.angle.begin()) return light.angle.front() > angle ? 0 : light.intensity.front();
  const auto i = static_cast<std::size_t>(next - light.angle.begin());
  if (next == light.angle.end()) return angle > light.angle.back() ? 0 : light.intensity.back();
  const double part = (angle - light.angle[i - 1]) / (light.angle[i] - light.angle[i - 1]);
  return light.intensity[i - 1] + part * (light.intensity[i] - light.intensity[i - 1]);
}

/// 2 pi times the integral of the shape times sin, closed for each linear piece: with i = a + b t,
/// the integral of (a + b t) sin t is -(a + b t) cos t + b sin t.
double integral_of_shape(const PointLight& light) {
  if (light.angle.empty()) return 4 * pi;
  double sum = 0;
  for (std::size_t i = 1; i < light.angle.size(); ++i) {
    const double t0 = light.angle[i - 1], t1 = light.angle[i];
    const double i0 = light.intensity[i - 1], i1 = light.intensity[i];
    if (t1 <= t0) continue;
    const double slope = (i1 - i0) / (t1 - t0);
    sum += i0 * std::cos(t0) - i1 * std::cos(t1) + slope * (std::sin(t1) - std::sin(t0));
  }
  return 2 * pi * sum;
}

}  // namespace

PointSource::PointSource(std::string name, const PointLight& light, const LightPaths& paths)
    : LightSource(std::move(name), light.power),
      light_(light),
      paths_(paths),
      norm_(integral_of_shape(light)) {
  for (const MirrorSet mirrors : paths.mirrors().images_of_point())
    images_.push_back({paths.mirrors().image(mirrors, light.position), mirrors});
}

double PointSource::intensity(const Image& image, const Vec3& direction) const {
  if (light_.angle.empty()) return 1 / norm_;
  const Vec3 sent = paths_.mirrors().image_direction(image.mirrors, direction);
  // Of a small angle the sine is the sounder measure.
  const double angle = std::atan2(light_.axis.cross(sent).norm(), light_.axis.dot(sent));
  return shape_at(light_, angle) / norm_;
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
