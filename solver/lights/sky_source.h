// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "solver/lights/wide_source.h"
#include "solver/problem/light.h"

namespace etendue {

/// Light from all over a sky: beams that each stand for a part of it, which enter through the same walls,
/// with their images behind mirrors. Of the lights of a problem beams in a row that have one name are a sky.
class SkySource : public WideSource {
 public:
  SkySource(std::string name, std::vector<BeamLight> parts, const LightPaths& paths);

  void add_beams(const PointInCell& at, Sight sight, LightDetail detail, LightBeams& beams) const override;
  void look_even(const Vec3& place, std::span<const double> extinction, std::optional<int> without,
                 LightBeams& beams, EvenLight& light) const override;
  bool is_near(const Vec3&, double) const override { return false; }
  bool is_soft() const override { return true; }
  std::span<const BeamLight> parts() const { return parts_; }

 private:
  std::vector<BeamLight> parts_;
  const LightPaths& paths_;
  std::vector<MirrorSet> images_;
};

/// Whether a light is a part of the same sky as the one before it.
bool continues_sky(std::span<const Light> lights, std::size_t light);

}  // namespace etendue
