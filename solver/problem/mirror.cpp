// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/problem/mirror.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace etendue {
namespace {

using std::numbers::pi;

/// Integral of 2 mu R dmu between two cosines; smooth between them but for a square root at the lower end,
/// which mu = a + (b - a) t^2 takes away.
double integral(double a, double b, double index) {
  constexpr int steps = 64;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double t = (i + 0.5) / steps, cosine = a + (b - a) * t * t;
    sum += 2 * cosine * fresnel_reflectance(cosine, index) * 2 * t * (b - a) / steps;
  }
  return sum;
}

}  // namespace

double fresnel_reflectance(double cosine, double index) {
  const double sine_behind = index * std::sqrt(std::max(0.0, 1 - cosine * cosine));
  if (sine_behind >= 1) return 1;
  const double cosine_behind = std::sqrt(1 - sine_behind * sine_behind);
  const double across = (index * cosine - cosine_behind) / (index * cosine + cosine_behind);
  const double along = (cosine - index * cosine_behind) / (cosine + index * cosine_behind);
  return (across * across + along * along) / 2;
}

// A circle at the angle t from the normal lies in the cone over 2 psi of its azimuths.
double mean_fresnel_reflectance(double cosine, double solid_angle, double index) {
  constexpr int steps = 256;
  const double angle = std::acos(std::clamp(cosine, 0.0, 1.0));
  const double opening = std::acos(std::max(-1.0, 1 - solid_angle / (2 * pi)));
  const double from = std::max(0.0, angle - opening), to = std::min(pi / 2, angle + opening);
  double sum = 0, reflected = 0;
  for (int i = 0; i < steps; ++i) {
    const double t = from + (to - from) * (i + 0.5) / steps;
    const double reach = (std::cos(opening) - std::cos(t) * cosine) / (std::sin(t) * std::sin(angle));
    const double psi = t < opening - angle ? pi : std::acos(std::clamp(reach, -1.0, 1.0));
    const double weight = psi * std::sin(t) * std::cos(t);
    sum += weight;
    reflected += weight * fresnel_reflectance(std::cos(t), index);
  }
  return reflected / sum;
}

bool is_mirror(const Wall& wall) {
  return wall.refractive_index != 1 || std::ranges::any_of(wall.specular, [](double r) { return r > 0; });
}

double mirrored_part(const Wall& wall, std::size_t band, double cosine) {
  return wall.refractive_index != 1 ? fresnel_reflectance(cosine, wall.refractive_index)
                                    : wall.specular[band];
}

double mirrored_part_of_isotropic(const Wall& wall, std::size_t band) {
  if (wall.refractive_index == 1) return wall.specular[band];
  const double total =
      std::sqrt(std::max(0.0, 1 - 1 / (wall.refractive_index * wall.refractive_index)));  // cosine
  return (wall.refractive_index > 1 ? total * total : 0) +
         integral(wall.refractive_index > 1 ? total : 0, 1, wall.refractive_index);
}

double radiance_sent(const Wall& wall, std::size_t band, double cosine) {
  const double n = wall.refractive_index;
  return wall.radiance[band] * (n == 1 ? 1 : n * n * (1 - fresnel_reflectance(cosine, n)));
}

double entering_part(const Wall& wall) {
  const double n = wall.refractive_index;
  return n == 1 ? 1 : n * n * (1 - mirrored_part_of_isotropic(wall, 0));
}

}  // namespace etendue
