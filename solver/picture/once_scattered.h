// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "solver/angle/leaf_canopy.h"
#include "solver/lights/light_setup.h"
#include "solver/problem/phase_list.h"

namespace etendue {

/// How light that has scattered once is found along a ray of a picture.
inline constexpr LightDetail shaft_light{0.7, 0.03, 0.6, 0.9, TriangleRule::three_points};

/// Light of the lights that scatters for the first time, with the phase function itself, not its series:
///
///     S_1(w) = sigma_s sum over the beams i of p(w.w_i) phi_i,
///
/// where matter depends on the directions themselves with its kernel k(w_i -> w) in place of sigma_s p.
class OnceScattered {
 public:
  /// The lights must outlive it.
  OnceScattered(const LightSetup& lights, int threads);

  /// Of the vertices that one ray looked at last, so that cells around a vertex share it.
  struct Memory {
    explicit Memory(const OnceScattered& scattered);
    /// To be called where the ray turns.
    void forget() {
      vertices.fill(-1);
      beam.reset();
    }
    static constexpr std::size_t places = 64;
    std::array<std::int32_t, places> vertices{};
    std::vector<double> values;  ///< [place][source][way to scatter]
    std::optional<Vec3> beam;    ///< of which matter was asked last: the sun's is the same everywhere
    std::vector<double> matter;  ///< [kind] what it scatters along the ray
  };

  /// Adds it at the vertices [4][band], from the fluence of each light as it is projected on the cell and
  /// from the directions in which it comes to the vertices.
  void add_at_vertices(CellIndex cell, const Vec3& travel, Memory& memory, std::span<double> values) const;
  /// Adds it at a point [band], by rays to the lights.
  void add_at(const PointInCell& point, const Vec3& travel, LightBeams& beams,
              std::span<double> values) const;

 private:
  /// Where the light comes from at a vertex: unit directions of travel and their shares of the fluence.
  struct Beam {
    Vec3 direction;
    double share;
    std::vector<double> scattered;  ///< [kind] of matter for a density of 1 [1/length]
  };
  void look_at_vertices(int threads);
  /// The way to scatter of a region and band: a phase function, or behind these a kind of matter that depends
  /// on the directions; -1 where all are alike.
  int way_of(int region, std::size_t band) const;
  /// [kind] k(beam -> travel) for a density of 1 [1/sr].
  void ask_matter(const Vec3& beam, const Vec3& travel, Memory& memory) const;
  const double* at_vertex(std::int32_t vertex, const Vec3& travel, Memory& memory) const;
  std::size_t ways() const { return phases_.phases().size() + matter_.kind_count(); }
  std::size_t pairs() const { return lights_.sources().size() * ways(); }

  const LightSetup& lights_;
  const Problem& problem_;
  PhaseList phases_;
  const RayMatter& matter_;
  std::vector<LeafNormals> normals_;  ///< [kind] of leaves
  /// [source][cell][4][band] fluence, or where something depends on the direction what scatters of it.
  std::vector<std::vector<double>> fluence_;
  std::vector<std::vector<Beam>> vertex_beams_;  ///< [vertex * sources + source]
};

}  // namespace etendue
