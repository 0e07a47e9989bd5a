// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "solver/problem/lights/light.h"
#include "solver/uncollided/sources/light_source.h"

namespace etendue {

/// A direction that comes back to that of a beam through mirrors does so to rounding.
inline constexpr double returning_direction = 1e-9;

/// Collimated light that enters through walls, with its images behind mirrors.
class BeamSource : public LightSource {
 public:
  BeamSource(std::string name, const BeamLight& light, const LightPaths& paths);

  void add_beams(const PointInCell& at, Sight sight, LightDetail detail, LightBeams& beams) const override;
  /// A cross-section has an edge, or varies, everywhere.
  bool is_near(const Vec3&, double) const override { return has_profile(); }
  const BeamSource* as_beam() const override { return this; }
  const BeamLight& light() const { return light_; }
  /// That of the beam and of its images behind mirrors.
  std::span<const Vec3> directions() const { return directions_; }
  /// [direction] The mirrors via which light arrives so.
  std::span<const MirrorSet> mirrors() const { return mirrors_; }
  /// The fluence [band] that arrives at a point along one of the directions; false if none does.
  bool arrives(const PointInCell& at, const Vec3& direction, std::span<double> fluence) const;
  /// Adds the light that comes to a point along direction number `image`.
  void add_beam(std::size_t image, const PointInCell& at, Sight sight, LightBeams& beams) const;

  /// Returns whether it has a cross-section of its own; else it is as wide as its walls.
  bool has_profile() const { return light_.profile.has_value(); }
  /// The parts of a triangle that light along direction number `image` can reach, each small enough for a
  /// rule of degree 5; without a profile all of it.
  std::vector<std::array<Vec3, 3>> lit_parts(std::size_t image, const std::array<Vec3, 3>& triangle) const;
  /// About the part of a cell of this size that it fills.
  double part_of_cell(double size) const;

 private:
  /// Irradiance of the ray through a point over that on the axis.
  static double part_on_ray(const std::optional<BeamProfile>& profile, const Vec3& point);

  BeamLight light_;
  const LightPaths& paths_;
  std::vector<Vec3> directions_;
  std::vector<MirrorSet> mirrors_;
  std::vector<std::optional<BeamProfile>> profiles_;  ///< [direction] of the image
};

}  // namespace etendue
