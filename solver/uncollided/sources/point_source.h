// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/problem/lights/light.h"
#include "solver/problem/lights/tangent_cone.h"
#include "solver/uncollided/sources/light_source.h"

namespace etendue {

/// A light at a point of the domain, with its images behind mirrors. It sends all of its power in directions
/// that lead into the domain: one on a wall nothing into the wall, and more to the other side.
class PointSource : public LightSource {
 public:
  /// `cone` has the directions that lead into the domain from the position.
  PointSource(std::string name, const PointLight& light, TangentCone cone, const LightPaths& paths);

  const Vec3& position() const { return light_.position; }
  struct Image {
    Vec3 position;
    MirrorSet mirrors;
  };
  const std::vector<Image>& images() const { return images_; }
  /// Part of the power that an image sends into a direction [1/sr].
  double intensity(const Image& image, const Vec3& direction) const;

  /// Directions along the edges of its cones, as an image sends them: each a closed polygon about the axis,
  /// of the solid angle of the cone.
  std::vector<std::vector<Vec3>> rims(const Image& image) const;

  void add_beams(const PointInCell& at, Sight sight, LightDetail detail, LightBeams& beams) const override;
  const PointSource* as_point() const override { return this; }
  bool is_near(const Vec3& place, double size) const override;

 private:
  PointLight light_;
  TangentCone cone_;
  const LightPaths& paths_;
  std::vector<Image> images_;
  double norm_;  ///< integral of the intensity's shape over the cone
};

}  // namespace etendue
