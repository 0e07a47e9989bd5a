// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "solver/angular/harmonics/harmonics.h"
#include "solver/angular/sets/direction_set.h"
#include "solver/transport/order/ordinate_schedule.h"

namespace etendue {

/// The symmetry that moments and ordinates share. Mirrors across x, y and z turn an ordinate into seven
/// others, and the harmonics of a symmetric set are even or odd at each of them: at all eight ordinates of an
/// orbit a harmonic has one value but for the sign. So harmonics fall into eight classes, and the sums over a
/// class at one ordinate serve all eight. On other sets an orbit is an ordinate and its opposite, and the
/// classes are those of even and of odd degree.
class MomentOrbits {
 public:
  /// Orbits as they come in the schedule, none of them in two batches.
  MomentOrbits(const DirectionSet& directions, const DiscreteHarmonics& harmonics,
               const OrdinateSchedule& schedule);

  int size() const { return size_; }  ///< ordinates of an orbit: 8 or 2
  int count() const { return static_cast<int>(ordinates_.size()) / size_; }
  /// Of 8, ordinate r is the first one mirrored across the axes whose bits r has. Harmonics of class c have
  /// the sign of (-1)^(bits that c and r share) there.
  std::span<const OrdinateIndex> ordinates(int orbit) const {
    return std::span(ordinates_)
        .subspan(static_cast<std::size_t>(orbit * size_), static_cast<std::size_t>(size_));
  }
  const std::vector<int>& order() const { return order_; }  ///< the moments, class by class
  const std::vector<int>& class_begin() const {
    return class_begin_;
  }  ///< [class], and the end: places there
  /// [batch][moment in that order][orbit of the batch] Y_k of the first ordinate
  std::span<const double> evaluation() const { return evaluation_; }
  std::span<const double> integration() const { return integration_; }  ///< w Y_k, likewise

 private:
  void find_orbits(const DirectionSet& directions, const OrdinateSchedule& schedule);
  void sort_moments(const std::vector<int>& classes);

  int size_;
  std::vector<OrdinateIndex> ordinates_;  ///< [orbit][size]
  std::vector<int> order_;
  std::vector<int> class_begin_;
  std::vector<double> evaluation_;
  std::vector<double> integration_;
};

}  // namespace etendue
