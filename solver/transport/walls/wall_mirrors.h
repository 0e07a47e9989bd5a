// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/errors.h"
#include "solver/angular/sets/direction_set.h"
#include "solver/problem/problem.h"
#include "solver/transport/order/ordinate_schedule.h"

namespace etendue {

/// Half ranges below this [sr] are those of walls that no direction reaches: the sides z = const in the
/// plane.
inline constexpr double out_of_reach = 1e-12;

/// Mirrors among the walls, refracting ones included: the ordinates that they turn into each other, and the
/// place of the radiance that they reflect. That is rows [mirror face][pair of ordinates][face node][stride],
/// for each of the two sweeps in which it may be reflected.
class WallMirrors {
 public:
  /// Sweep in which a mirror reflects the radiance that arrives.
  enum class Pass { this_sweep, next_sweep };

  /// Plane of mirrors with one refractive index.
  struct Plane {
    Vec3 normal;
    double refractive_index;  ///< 1: that of a mirror
    Pass pass;
    std::vector<std::int32_t> partner;  ///< [ordinate]
    std::vector<double> reflected;  ///< [ordinate] where it refracts, equation (13a) of docs/theory/theory.md
  };

  /// Boundary face that is a mirror.
  struct Mirror {
    std::size_t plane;
    std::size_t row;  ///< among those of its pass
  };

  /// `half_range` is [boundary face] [sr], `face_length` face nodes times stride. Throws InputError where a
  /// mirror's partner ordinate is not in the set. Problem and directions must outlive it.
  WallMirrors(const Problem& problem, const DirectionSet& directions, const OrdinateSchedule& schedule,
              std::span<const double> half_range, std::size_t face_length);

  /// The mirror of a boundary face; null where it is none.
  const Mirror* find(FaceIndex face) const {
    const std::int32_t at = mirror_of_[face.at()];
    return at < 0 ? nullptr : &mirrors_[static_cast<std::size_t>(at)];
  }
  const Plane& plane(const Mirror& mirror) const { return planes_[mirror.plane]; }
  /// Boundary faces that are mirrors.
  const std::vector<std::int32_t>& faces() const { return faces_; }
  /// Whether a face is a mirror that reflects in the next sweep.
  bool reflects_later(FaceIndex face) const {
    const Mirror* mirror = find(face);
    return mirror != nullptr && plane(*mirror).pass == Pass::next_sweep;
  }

  /// Numbers of all rows of a pass.
  std::size_t size(Pass pass) const { return rows_[static_cast<std::size_t>(pass)] * row_size(); }
  /// First number of an ordinate in the rows of a mirror's pass. One of the two ordinates of a pair leaves
  /// through a face, so the number of the pair is enough.
  std::size_t first_number(const Mirror& mirror, std::int32_t ordinate) const {
    return mirror.row * row_size() + static_cast<std::size_t>(ordinate / 2) * face_length_;
  }
  /// Replaces the half range of the faces that refract by the flux that a radiance of 1 of their walls sends
  /// in [sr].
  void set_emission_range(std::vector<double>& range) const;

 private:
  std::size_t row_size() const { return static_cast<std::size_t>(directions_.count() / 2) * face_length_; }
  /// Index of the plane of a face, which is added where it is new; -1 where an ordinate has no partner.
  std::ptrdiff_t plane_of(FaceIndex face, const OrdinateSchedule& schedule);
  Plane make_plane(FaceIndex face, const OrdinateSchedule& schedule) const;
  Fault fault_of(FaceIndex face) const;

  const Problem& problem_;
  const DirectionSet& directions_;
  std::size_t face_length_;
  std::vector<std::int32_t> mirror_of_;  ///< [boundary face] its mirror, -1 where it is none
  std::vector<Mirror> mirrors_;
  std::vector<Plane> planes_;
  std::array<std::size_t, 2> rows_{};  ///< [pass]
  std::vector<std::int32_t> faces_;
};

}  // namespace etendue
