// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/scattering/moment_orbits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace etendue {
namespace {

/// Difference of harmonics, which are about 1, that is rounding.
constexpr double harmonics_rounding = 1e-9;

constexpr int no_class = -1;

/// [axis][ordinate]
using Images = std::array<std::vector<OrdinateIndex>, 3>;

/// Bit a where a harmonic is odd across axis a; no_class where it is neither odd nor even.
int class_of(const Images& images, const DiscreteHarmonics& harmonics, int k) {
  int result = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    bool is_even = true, is_odd = true;
    for (std::size_t m = 0; m < images[axis].size() && (is_even || is_odd); ++m) {
      const double here = harmonics.value(k, OrdinateIndex(static_cast<std::int64_t>(m)));
      const double there = harmonics.value(k, images[axis][m]);
      is_even = is_even && std::abs(there - here) < harmonics_rounding;
      is_odd = is_odd && std::abs(there + here) < harmonics_rounding;
    }
    if (!is_even && !is_odd) return no_class;
    result |= (is_odd ? 1 : 0) << axis;
  }
  return result;
}

/// [moment]
std::vector<int> classes_of_mirrors(const DirectionSet& directions, const DiscreteHarmonics& harmonics) {
  Images images;
  for (int axis = 0; axis < 3; ++axis)
    for (std::int32_t m = 0; m < directions.count(); ++m)
      images[static_cast<std::size_t>(axis)].emplace_back(
          directions.mirrored(OrdinateIndex(m), Vec3::Unit(axis)));
  std::vector<int> classes;
  for (int k = 0; k < harmonics.count(); ++k) classes.push_back(class_of(images, harmonics, k));
  return classes;
}

std::vector<int> classes_of_opposites(const DiscreteHarmonics& harmonics) {
  std::vector<int> classes;
  for (int k = 0; k < harmonics.count(); ++k) classes.push_back(harmonics.degree_of(k) % 2);
  return classes;
}

}  // namespace

MomentOrbits::MomentOrbits(const DirectionSet& directions, const DiscreteHarmonics& harmonics,
                           const OrdinateSchedule& schedule)
    : size_(schedule.keeps_images_together() ? 8 : 2) {
  std::vector<int> classes;
  if (size_ == 8) classes = classes_of_mirrors(directions, harmonics);
  if (size_ == 2 || std::count(classes.begin(), classes.end(), no_class) > 0) {
    size_ = 2;
    classes = classes_of_opposites(harmonics);
  }
  find_orbits(directions, schedule);
  sort_moments(classes);
  const int in_batch = schedule.batch() / size_;
  for (int begin = 0; begin < count(); begin += in_batch)
    for (const int k : order_)
      for (int orbit = begin; orbit < std::min(count(), begin + in_batch); ++orbit) {
        const OrdinateIndex first = ordinates(orbit)[0];
        evaluation_.push_back(harmonics.value(k, first));
        integration_.push_back(harmonics.value(k, first) * directions.weight(first));
      }
}

void MomentOrbits::find_orbits(const DirectionSet& directions, const OrdinateSchedule& schedule) {
  std::vector<char> seen(static_cast<std::size_t>(directions.count()), 0);
  for (std::int32_t place = 0; place < schedule.place_count(); ++place) {
    const OrdinateIndex first = schedule.ordinate(place);
    if (seen[first.at()]) continue;
    const std::size_t begin = ordinates_.size();
    ordinates_.push_back(first);
    if (size_ == 2) {
      ordinates_.emplace_back(first.value() ^ 1);
    } else {
      for (int axis = 0; axis < 3; ++axis)
        for (std::size_t r = 0; r < std::size_t{1} << axis; ++r)
          ordinates_.emplace_back(directions.mirrored(ordinates_[begin + r], Vec3::Unit(axis)));
    }
    for (std::size_t i = begin; i < ordinates_.size(); ++i) seen[ordinates_[i].at()] = 1;
  }
}

void MomentOrbits::sort_moments(const std::vector<int>& classes) {
  order_.resize(classes.size());
  std::iota(order_.begin(), order_.end(), 0);
  const auto class_of = [&](int k) { return classes[static_cast<std::size_t>(k)]; };
  std::stable_sort(order_.begin(), order_.end(), [&](int a, int b) { return class_of(a) < class_of(b); });
  for (int c = 0; c <= size_; ++c)
    class_begin_.push_back(static_cast<int>(
        std::partition_point(order_.begin(), order_.end(), [&](int k) { return class_of(k) < c; }) -
        order_.begin()));
}

}  // namespace etendue
