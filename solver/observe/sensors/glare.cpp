// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/sensors/glare.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace etendue {
namespace {

using std::numbers::pi;

/// Bounds of evalglare.
constexpr double most_ratio_below = 3, most_index = 16;

double index_below(double ratio) {
  const double r = std::min(ratio, most_ratio_below);
  return 1 + (r < 0.6 ? 0.8 : 1.2) * r;
}

double index_above(double sigma, double tau) {
  const double linear = 35.2 - 0.31889 * tau - 1.22 * std::exp(-2 * tau / 9);
  const double square = 21 + 0.26667 * tau - 0.002963 * tau * tau;
  return std::exp(1e-3 * linear * sigma + 1e-5 * square * sigma * sigma);
}

/// Sums over the pixels of a group.
struct Group {
  Vec3 weighted = Vec3::Zero();  ///< of the directions, by luminance and solid angle
  double flux = 0;               ///< luminance times solid angle
  double solid_angle = 0;

  void add(const Group& other) {
    weighted += other.weighted;
    flux += other.flux;
    solid_angle += other.solid_angle;
  }
  double angle_to(const Group& other) const {
    return std::acos(std::clamp(weighted.normalized().dot(other.weighted.normalized()), -1.0, 1.0));
  }
};

/// All that hangs together with a pixel, which is marked as dark then.
Group group_of(const LuminanceView& view, std::size_t first, std::vector<char>& bright) {
  Group group;
  std::vector<std::size_t> open = {first};
  bright[first] = 0;
  const auto across = static_cast<std::size_t>(view.across);
  while (!open.empty()) {
    const std::size_t at = open.back();
    open.pop_back();
    const double flux = view.luminance[at] * view.solid_angle[at];
    group.add({flux * view.directions[at], flux, view.solid_angle[at]});
    const std::size_t row = at / across, column = at % across;
    for (std::size_t r = row == 0 ? 0 : row - 1; r <= std::min(row + 1, across - 1); ++r)
      for (std::size_t c = column == 0 ? 0 : column - 1; c <= std::min(column + 1, across - 1); ++c)
        if (bright[r * across + c] != 0) {
          bright[r * across + c] = 0;
          open.push_back(r * across + c);
        }
  }
  return group;
}

/// Joins those whose middles are near to each other, until none are.
void join_groups(std::vector<Group>& groups, double join) {
  for (std::size_t i = 0; i < groups.size();) {
    const auto near = std::find_if(groups.begin() + static_cast<std::ptrdiff_t>(i) + 1, groups.end(),
                                   [&](const Group& other) { return groups[i].angle_to(other) < join; });
    if (near == groups.end()) {
      ++i;
      continue;
    }
    groups[i].add(*near);
    groups.erase(near);
    i = 0;
  }
}

double sum_of_sources(std::span<const GlareSource> sources) {
  double sum = 0;
  for (const GlareSource& source : sources)
    sum += source.luminance * source.luminance * source.solid_angle / (source.position * source.position);
  return sum;
}

}  // namespace

double guth_position_index(const LineOfSight& sight, const Vec3& towards) {
  const double distance = towards.dot(sight.ahead);
  const Vec3 up = (sight.up - sight.up.dot(sight.ahead) * sight.ahead).normalized();
  const Vec3 aside = towards - distance * sight.ahead;
  if (aside.norm() == 0) return 1;
  const double height = aside.dot(up);
  if (height < 0) return distance > 0 ? index_below(aside.norm() / distance) : index_below(most_ratio_below);
  const double sigma = std::acos(std::clamp(distance, -1.0, 1.0)) * 180 / pi;
  const double tau = std::acos(std::clamp(height / aside.norm(), -1.0, 1.0)) * 180 / pi;
  return std::min(index_above(sigma, tau), most_index);
}

double mean_luminance(const LuminanceView& view) {
  double flux = 0, solid_angle = 0;
  for (std::size_t i = 0; i < view.luminance.size(); ++i) {
    flux += view.luminance[i] * view.solid_angle[i];
    solid_angle += view.solid_angle[i];
  }
  return flux / solid_angle;
}

std::vector<GlareSource> glare_sources(const LuminanceView& view, const std::vector<char>& is_bright,
                                       const LineOfSight& sight, double join) {
  std::vector<char> bright = is_bright;
  std::vector<Group> groups;
  for (std::size_t at = 0; at < bright.size(); ++at)
    if (bright[at] != 0) groups.push_back(group_of(view, at, bright));
  join_groups(groups, join);
  std::vector<GlareSource> sources;
  for (const Group& group : groups) {
    const Vec3 towards = group.weighted.normalized();
    sources.push_back(
        {towards, group.flux / group.solid_angle, group.solid_angle, guth_position_index(sight, towards)});
  }
  return sources;
}

double unified_glare_rating(std::span<const GlareSource> sources, double background) {
  const double sum = sum_of_sources(sources);
  return sum > 0 ? std::max(0.0, 8 * std::log10(0.25 / background * sum)) : 0;
}

double daylight_glare_probability(std::span<const GlareSource> sources, double eye_illuminance) {
  const double contrast = sum_of_sources(sources) / std::pow(eye_illuminance, 1.87);
  const double probability = 5.87e-5 * eye_illuminance + 9.18e-2 * std::log10(1 + contrast) + 0.16;
  constexpr double low_light = 1000;
  const double x = std::exp(0.024 * eye_illuminance - 4);
  return std::min(1.0, eye_illuminance < low_light ? probability * x / (1 + x) : probability);
}

}  // namespace etendue
