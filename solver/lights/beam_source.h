// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/lights/light_source.h"
#include "solver/problem/light.h"

namespace etendue {

/// Collimated light that enters through walls, with its images behind mirrors.
class BeamSource : public LightSource {
 public:
  BeamSource(std::string name, const BeamLight& light, const LightPaths& paths);

  void add_beams(const PointInCell& at, Sight sight, LightDetail detail, LightBeams& beams) const override;
  bool is_near(const Vec3&, double) const override { return false; }
  const BeamSource* as_beam() const override { return this; }
  const BeamLight& light() const { return light_; }
  /// That of the beam and of its images behind mirrors.
  std::span<const Vec3> directions() const { return directions_; }
  /// [direction] The mirrors by way of which light comes so.
  std::span<const MirrorSet> mirrors() const { return mirrors_; }
  /// The fluence [band] that arrives at a point along one of the directions; false if none does.
  bool arrives(const PointInCell& at, const Vec3& direction, std::span<double> fluence) const;

 private:
  /// Irradiance of the ray through a point over that on the axis; there are no mirrors beside a profile.
  double part_on_ray(const Vec3& point) const;

  BeamLight light_;
  const LightPaths& paths_;
  std::vector<Vec3> directions_;
  std::vector<MirrorSet> mirrors_;
};

}  // namespace etendue
