// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/uncollided/moments/incident_directions.h"

namespace etendue {

/// Integrals over one cell of the light that scatters, by the direction from which it comes: for each shape
/// function i and direction v
///
///     integral over K of shape_i sigma_s sum over the light's directions w of a_v(w) u(w) dV,
///
/// with the weights a_v of IncidentDirections.
class DirectionalMoments {
 public:
  DirectionalMoments(const IncidentDirections& directions, std::size_t bands)
      : directions_(&directions), bands_(bands) {
    clear();
  }

  std::size_t bands() const { return bands_; }
  void set_detail(AngularDetail detail) {
    detail_ = detail;
    aimed_ = false;
  }
  void clear();
  void add(const DirectionalMoments& other);
  /// Adds `power` times the shape functions [4] of light that travels in a direction.
  void add(const Vec3& direction, std::span<const double> shape, std::size_t band, double power);

  /// Of the directions that have been found so far: their numbers, and values [4][band] of each.
  std::span<const std::int32_t> found() const { return found_; }
  std::span<double> values(std::size_t place) {
    return std::span(values_).subspan(place * 4 * bands_, 4 * bands_);
  }
  std::span<const double> values(std::size_t place) const {
    return std::span(values_).subspan(place * 4 * bands_, 4 * bands_);
  }

 private:
  std::size_t place_of(std::int32_t direction);
  void grow();

  const IncidentDirections* directions_;
  std::size_t bands_;
  AngularDetail detail_ = AngularDetail::fine;
  std::vector<std::int32_t> found_;
  std::vector<double> values_;       ///< [place][4][band]
  std::vector<std::int32_t> table_;  ///< open addressing: places, -1 where free; a power of two
  // The direction that was asked last; light comes several times from each.
  bool aimed_ = false;
  Vec3 last_ = Vec3::Zero();
  std::array<std::size_t, 3> aim_{};
  std::array<double, 3> weight_{};
};

}  // namespace etendue
