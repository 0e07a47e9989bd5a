// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/angular/refraction/ordinate_reflectance.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "solver/angular/refraction/polar_levels.h"
#include "solver/problem/mirror.h"

namespace etendue {
namespace {

/// [level] Means of 1 - R over the bins of mu^2 that hold the flux of each level.
std::vector<double> transmittances(const std::vector<PolarLevel>& levels, double index) {
  double half_range = 0;
  for (const PolarLevel& level : levels) half_range += level.weight * level.cosine;
  std::vector<double> means;
  double upper = 1, above = 2 * transmitted_moment(1, 1, index), flux = 0;
  for (const PolarLevel& level : levels) {
    flux += level.weight * level.cosine;
    const double lower = std::max(0.0, 1 - flux / half_range);
    const double below = 2 * transmitted_moment(std::sqrt(lower), 1, index);
    means.push_back(upper > lower ? std::clamp((above - below) / (upper - lower), 0.0, 1.0) : 0);
    upper = lower;
    above = below;
  }
  return means;
}

/// Shifts transmitted light between the levels at equal flux: t + a (m - mu) t (1 - t), m the mean cosine
/// over the flux-weighted t (1 - t), and a such that the zeroth moment is exact, as far as t stays in [0, 1].
void match_zeroth_moment(const std::vector<PolarLevel>& levels, double index, std::vector<double>& parts) {
  double weight = 0, moment = 0, shift = 0, shift_flux = 0, shift_second = 0;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const auto [cosine, solid_angle] = levels[i];
    const double room = solid_angle * parts[i] * (1 - parts[i]);
    weight += solid_angle;
    moment += solid_angle * parts[i];
    shift += room;
    shift_flux += room * cosine;
    shift_second += room * cosine * cosine;
  }
  if (shift_flux <= 0) return;
  const double mean = shift_second / shift_flux, gain = mean * shift - shift_flux;
  double farthest = 0;
  for (std::size_t i = 0; i < levels.size(); ++i)
    if (parts[i] > 0) farthest = std::max(farthest, std::abs(mean - levels[i].cosine));
  constexpr double one_level = 1e-12;  // of the solid angle: nothing to shift between
  if (gain <= one_level * weight) return;
  const double wanted = (weight * transmitted_moment(1, 0, index) - moment) / gain;
  const double factor = std::clamp(wanted, -1 / farthest, 1 / farthest);
  for (std::size_t i = 0; i < levels.size(); ++i)
    parts[i] += factor * (mean - levels[i].cosine) * parts[i] * (1 - parts[i]);
}

}  // namespace

std::vector<double> ordinate_reflectances(const DirectionSet& directions, const Wall& wall,
                                          const Vec3& normal) {
  const PolarLevels levels(directions, normal);
  std::vector<double> parts = transmittances(levels.levels(), wall.refractive_index);
  match_zeroth_moment(levels.levels(), wall.refractive_index, parts);
  std::vector<double> reflected(static_cast<std::size_t>(directions.count()));
  for (std::size_t m = 0; m < reflected.size(); ++m) reflected[m] = 1 - parts[levels.of_ordinate(m)];
  return reflected;
}

}  // namespace etendue
