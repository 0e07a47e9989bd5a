// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/problem/mirror.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace etendue {
namespace {

/// Gauss' rule with three points on [0, 1], which transmitted_moment repeats on panels.
constexpr std::array<double, 3> points = {0.1127016653792583, 0.5, 0.8872983346207417};
constexpr std::array<double, 3> weights = {5.0 / 18, 8.0 / 18, 5.0 / 18};

}  // namespace

double fresnel_reflectance(double cosine, double index) {
  const double sine_behind = index * std::sqrt(std::max(0.0, 1 - cosine * cosine));
  if (sine_behind >= 1) return 1;
  const double cosine_behind = std::sqrt(1 - sine_behind * sine_behind);
  const double across = (index * cosine - cosine_behind) / (index * cosine + cosine_behind);
  const double along = (cosine - index * cosine_behind) / (cosine + index * cosine_behind);
  return (across * across + along * along) / 2;
}

double critical_cosine(double index) { return std::sqrt(std::max(0.0, 1 - 1 / (index * index))); }

// The transmitted part rises like a square root at the critical cosine c: in t of mu = c + (cosine - c) t^2
// it is smooth.
double transmitted_moment(double cosine, int power, double index) {
  constexpr int panels = 32;
  const double critical = critical_cosine(index), length = cosine - critical;
  if (length <= 0) return 0;
  double sum = 0;
  for (int panel = 0; panel < panels; ++panel)
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double t = (panel + points[i]) / panels, mu = critical + length * t * t;
      sum +=
          weights[i] / panels * 2 * t * length * std::pow(mu, power) * (1 - fresnel_reflectance(mu, index));
    }
  return sum;
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
  return 1 - 2 * transmitted_moment(1, 1, wall.refractive_index);
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
