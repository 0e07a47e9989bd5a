// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "solver/angular/sets/direction_set.h"
#include "solver/problem/problem.h"

namespace etendue {

/// 0 ... 7, a bit for each component below zero.
inline unsigned octant(const Vec3& direction) {
  return (direction.x() < 0 ? 1U : 0U) | (direction.y() < 0 ? 2U : 0U) | (direction.z() < 0 ? 4U : 0U);
}

/// The most ordinates of a group.
inline constexpr std::int32_t largest_group = 8;

/// Which ordinates share a batch: neighbours, or those that mirrors across all axes turn into each other, be
/// there such mirrors or not, so that their moments are found together (moment_orbits.h).
enum class Batches { of_neighbours, of_images };

/// The order in which a sweep takes the ordinates, batch by batch. Among mirrors across the axes a batch
/// holds all that its ordinates become there, and takes first those whose reflections others wait for: so one
/// mirror, or mirrors at right angles, need nothing from the last sweep, and of two that face each other only
/// one does (Warsa, Wareing and Morel 2004 lag both). Within a batch the ordinates of one octant stand
/// together, in groups that go through the mesh tile by tile at the same time.
class OrdinateSchedule {
 public:
  OrdinateSchedule(const Problem& problem, const DirectionSet& directions, Batches batches);

  OrdinateIndex ordinate(std::int32_t place) const {
    return OrdinateIndex(ordinates_[static_cast<std::size_t>(place)]);
  }
  /// Opposite ordinates lie in one batch.
  std::int32_t place_of(OrdinateIndex m) const { return place_of_[m.at()]; }
  std::int32_t batch() const { return batch_; }  ///< ordinates of one batch, but for the last
  std::int32_t batch_count() const { return (place_count() + batch_ - 1) / batch_; }
  std::int32_t place_count() const { return static_cast<std::int32_t>(ordinates_.size()); }
  /// The place behind the last of a batch.
  std::int32_t batch_end(std::int32_t batch) const { return std::min(place_count(), (batch + 1) * batch_); }
  /// The place behind the last of the group that begins at `place`.
  std::int32_t group_end(std::int32_t place) const { return group_end_[static_cast<std::size_t>(place)]; }
  /// Returns true where every ordinate has seven images across the axes, all in its batch; only where that
  /// was asked for.
  bool keeps_images_together() const { return keeps_images_together_; }
  /// Whether an ordinate comes after those that a mirror with this normal, out of the domain, turns into it.
  bool knows_reflections(const Vec3& normal) const;

 private:
  void find_axes(const Problem& problem);
  void find_groups(const DirectionSet& directions);
  int turns(const Vec3& direction) const;

  std::int32_t batch_;
  std::vector<std::int32_t> ordinates_;  ///< [place]
  std::vector<std::int32_t> place_of_;   ///< [ordinate]
  std::vector<std::int32_t> group_end_;  ///< [place]
  /// [axis] the sign of the component of ordinates that come after their mirror images; 0: there is no
  /// mirror.
  std::array<int, 3> later_{};
  bool keeps_images_together_;
};

}  // namespace etendue
