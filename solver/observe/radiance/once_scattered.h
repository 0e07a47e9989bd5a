// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "solver/materials/kernels/leaf_canopy.h"
#include "solver/problem/phase_list.h"
#include "solver/uncollided/first_collision/first_collisions.h"
#include "solver/uncollided/lights/light_setup.h"

namespace etendue {

/// How light that has scattered once is found along a ray of a picture.
inline constexpr LightDetail shaft_light{0.7, 0.03, 0.6, 0.9, TriangleRule::three_points};

/// Light of the lights that scatters for the first time, with the phase function itself, not its series:
///
///     S_1(w) = sigma_s sum over the beams i of p(w.w_i) phi_i,
///
/// where a medium depends on the directions themselves with its kernel k(w_i -> w) in place of sigma_s p.
class OnceScattered {
 public:
  /// The lights must outlive it.
  OnceScattered(const LightSetup& lights, std::shared_ptr<const FirstCollisions> first);

  const std::shared_ptr<const FirstCollisions>& first() const { return first_; }

  /// What scatters along one ray, by the direction from which it comes: cells on the ray share it.
  struct Memory {
    explicit Memory(const OnceScattered& scattered);
    /// To be called where the ray turns.
    void forget() {
      ++ray;
      beam.reset();
    }
    std::uint32_t ray = 1;
    std::vector<std::uint32_t> known;  ///< [incident direction] the ray for which its values hold
    std::vector<double> values;        ///< [incident direction][way to scatter] P - 1/(4 pi) [1/sr]
    std::optional<Vec3> beam;  ///< for which the medium was evaluated last: the sun's is the same everywhere
    std::vector<double> matter;  ///< [kind] what it scatters along the ray
  };

  /// Adds it at the vertices [4][band], from what is projected on the cell (CollisionField).
  void add_at_vertices(CellIndex cell, const Vec3& travel, Memory& memory, std::span<double> values) const;
  /// Adds it at a point [band], by rays to the lights.
  void add_at(const PointInCell& point, const Vec3& travel, LightBeams& beams,
              std::span<double> values) const;

 private:
  /// The way to scatter of a region and band: a phase function, or behind these a kind of medium that depends
  /// on the directions; -1 where all are alike.
  int way_of(int region, std::size_t band) const;
  /// [kind] k(beam -> travel) for a density of 1 [1/sr].
  void ask_matter(const Vec3& beam, const Vec3& travel, Memory& memory) const;
  /// [way] of an incident direction.
  const double* scattered_from(std::size_t direction, const Vec3& travel, Memory& memory) const;
  std::size_t ways() const { return phases_.phases().size() + matter_.kind_count(); }

  const LightSetup& lights_;
  const Problem& problem_;
  PhaseList phases_;
  const RayMatter& matter_;
  std::vector<LeafNormals> normals_;  ///< [kind] of leaves
  std::shared_ptr<const FirstCollisions> first_;
  std::vector<double> unit_scattering_;  ///< [incident direction][kind] for a density of 1 [1/length]
};

}  // namespace etendue
