// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "solver/angle/direction_set.h"
#include "solver/ordinates/sweep_slots.h"
#include "solver/ordinates/transport_state.h"
#include "solver/problem/problem.h"

namespace etendue {

/// What the walls send in and take up, direction by direction:
///
///     u_in = radiance + (diffuse / pi_h) E + specular u_out(mirrored),    pi_h = sum of w |w.n| over w.n <
///     0,
///
/// with the discrete half range pi_h in place of pi, so that a wall gives back exactly what it reflects.
/// Walls across z that no direction of the plane reaches take no part.
class WallExchange {
 public:
  /// Throws InputError where a mirror's partner ordinate is not in the set. The arguments must outlive it.
  WallExchange(const Problem& problem, const DirectionSet& directions, const WallSlots& wall_slots,
               int stride, int face_nodes);

  std::size_t irradiance_size() const;
  std::size_t mirror_size() const;
  /// Whether what arrives at some wall comes back.
  bool reflects() const { return reflects_; }
  /// [boundary face] [sr]
  const std::vector<double>& half_range() const { return half_range_; }
  /// Boundary faces whose walls reflect in some band.
  bool reflects(FaceIndex face) const {
    return wall_reflects_[static_cast<std::size_t>(mesh_.wall(face))] != 0;
  }

  /// Writes the inflow slots along ordinate m, from the last state. Adds what is sent to `exitance`
  /// [boundary face][face node][stride] unless that is empty.
  void send(OrdinateIndex m, const TransportState& last, Emission emission, const SweepSlots& slots,
            std::span<double> exitance) const;

  /// Takes up what left along ordinate m, from the radiance of the cells at the walls: adds to `irradiance`,
  /// and writes the mirrors' part of `next`.
  void receive(OrdinateIndex m, const SweepSlots& slots, std::span<double> irradiance,
               std::span<double> mirrors) const;

 private:
  struct MirrorPlane {
    Vec3 normal;
    std::vector<std::int32_t> partner;  ///< [ordinate]
  };

  void find_mirrors();
  std::vector<std::int32_t> partners(FaceIndex face) const;
  std::size_t mirror_at(std::size_t row, std::int32_t ordinate) const;

  const TetrahedralMesh& mesh_;
  const Problem& problem_;
  const DirectionSet& directions_;
  const WallSlots& wall_slots_;
  std::size_t stride_;
  std::size_t face_length_;                 ///< face nodes times stride
  std::vector<double> half_range_;          ///< [boundary face]
  std::vector<double> radiance_;            ///< [wall][stride]
  std::vector<double> diffuse_;             ///< [wall][stride]
  std::vector<double> specular_;            ///< [wall][stride]
  std::vector<char> wall_reflects_;         ///< [wall]
  std::vector<char> wall_diffuse_;          ///< [wall]
  std::vector<std::int32_t> mirror_row_;    ///< [boundary face], -1 where it is no mirror
  std::vector<std::int32_t> mirror_plane_;  ///< [mirror row]
  std::vector<MirrorPlane> planes_;
  bool reflects_ = false;
};

}  // namespace etendue
