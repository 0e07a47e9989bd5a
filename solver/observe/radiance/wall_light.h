// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "solver/angular/sets/direction_set.h"
#include "solver/observe/radiance/wall_corners.h"
#include "solver/solution/saved_state.h"
#include "solver/uncollided/lights/light_irradiance.h"
#include "solver/uncollided/lights/light_setup.h"

namespace etendue {

/// Sampling of the light of the lights where a ray of a picture meets a wall: mostly 16 rays to a lamp; more
/// where some of them are in the shadow, or where the haze that they pass is not alike, so that no edges of
/// single shadows are seen. Flat lamps are cut along the edges of walls that stand before them instead.
inline constexpr LightDetail wall_light_detail{0.4, 0.02, 0.6, 0.9, TriangleRule::three_points};
inline constexpr LightDetail penumbra_detail{0.12, 0.01, 0.15, 0.3, TriangleRule::three_points};
inline constexpr LightDetail cut_detail{0, 0, 0.6, 0.9, TriangleRule::seven_points};

/// The first of ever coarser details, from one on, by which a source sends no more than so many beams to a
/// point where nothing is in between; the coarsest where it has more parts than that. `beams` is room to
/// work in, and then holds these.
LightDetail detail_within(const LightSource& source, const PointInCell& point, LightDetail detail, int rays,
                          LightBeams& beams);

/// What directions brought to the walls, as a picture takes it.
struct WallIrradiance {
  std::vector<double> values;      ///< [boundary face][3][band] [power/length^2]
  std::vector<double> half_range;  ///< [boundary face] what it is divided by to be reflected [sr]
};

/// Whether what directions brought to the walls is made continuous within each plane, or taken as the
/// solution has it in each face.
enum class WallValues { joined, raw };

/// The radiance that walls send back.
class WallLight {
 public:
  /// The arguments must outlive it. `face_nodes` is 3, or 1 with constant elements, whose values are always
  /// joined.
  WallLight(const LightSetup& lights, const DirectionSet& directions, const SavedState& state,
            std::size_t face_nodes, WallValues values = WallValues::joined);

  /// Adds the radiance [band] that a wall reflects diffusely at a point of a face, or transmits from behind:
  /// of the light that directions carried, (diffuse/pi_h) E,
  /// and of the lights' own, (diffuse/pi) E_0 as add_light() finds it.
  void add_reflected(FaceIndex face, const Vec3& point, const WallIrradiance& brought, int shadow_rays,
                     LightBeams& beams, std::span<double> radiance) const;

  /// What is transmitted from behind alone.
  void add_transmitted(FaceIndex face, const Vec3& point, const WallIrradiance& brought, int shadow_rays,
                       LightBeams& beams, std::span<double> radiance) const;

  /// What is reflected alone, where the lights are known to bring `irradiance` [band] to the point.
  void add_reflected(FaceIndex face, const Vec3& point, const WallIrradiance& brought,
                     std::span<const double> irradiance, std::span<double> radiance) const;

  /// Adds the part `share` [band] of the irradiance of a face as radiance that is the same in all directions,
  /// by rays to the lights.
  void add_sent_on(FaceIndex face, const Vec3& point, std::span<const double> share,
                   const WallIrradiance& brought, int shadow_rays, LightBeams& beams,
                   std::span<double> radiance) const;

  /// The beams of one light at a point of a cell, and of one with an extent those that would come in empty
  /// space. From a light with an extent come 16 at most, or `shadow_rays` where those are fewer; where these
  /// are more, so many at most come where the first are not all alike. A flat light of few triangles is cut
  /// along what hides it where `shadow_rays` is above 16, however many come then.
  void find_beams(const LightSource& source, const PointInCell& point, int shadow_rays, LightBeams& beams,
                  LightBeams& clear) const;

  /// Adds the irradiance [band] of the lights at a point of a cell, on the side that light with w.n > 0
  /// meets; what flat lights bring in empty space is known (LightIrradiance).
  void add_light(const PointInCell& point, const Vec3& normal, int shadow_rays, LightBeams& beams,
                 std::span<double> irradiance) const;

  /// Adds the radiance [band] of a wall whose emission follows from the light (Problem::following()).
  void add_following(FaceIndex face, const Vec3& point, std::span<double> radiance) const;

  /// What directions brought, as the solution has it.
  const WallIrradiance& brought() const { return brought_; }

 private:
  /// The same with the irradiance that the lights are known to bring.
  void add_sent_on(FaceIndex face, const Vec3& point, std::span<const double> share,
                   const WallIrradiance& brought, std::span<const double> irradiance,
                   std::span<double> radiance) const;
  /// Returns whether the beams that are seen have not lost alike; or, where asked, some are hidden.
  bool are_unlike(const LightBeams& clear, const LightBeams& seen, bool hidden_too = false) const;

  const LightSetup& lights_;
  const Problem& problem_;
  std::size_t bands_;
  LightIrradiance irradiance_;
  std::vector<ShadowEdge> edges_;     ///< of walls
  std::vector<std::int32_t> behind_;  ///< [boundary face] other side of a sheet, -1: none
  WallIrradiance brought_;
  std::vector<double> following_;  ///< [boundary face][3][band]; empty: none
};

}  // namespace etendue
