// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/lights/light_source.h"
#include "solver/problem/light.h"

namespace etendue {

/// A light at a point of the domain, with its images behind mirrors.
class PointSource : public LightSource {
 public:
  PointSource(std::string name, const PointLight& light, const LightPaths& paths);

  struct Image {
    Vec3 position;
    MirrorSet mirrors;
  };
  const std::vector<Image>& images() const { return images_; }
  /// Part of the power that an image sends into a direction [1/sr].
  double intensity(const Image& image, const Vec3& direction) const;

  void add_beams(const PointInCell& at, Sight sight, LightDetail detail, LightBeams& beams) const override;
  const PointSource* as_point() const override { return this; }
  bool is_near(const Vec3& place, double size) const override;

 private:
  PointLight light_;
  const LightPaths& paths_;
  std::vector<Image> images_;
  double norm_;  ///< integral of the intensity's shape over the sphere
};

}  // namespace etendue
