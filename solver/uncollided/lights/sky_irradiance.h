// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "solver/uncollided/sources/sky_source.h"

namespace etendue {

/// What a sky brings to a point through the faces by which it comes in. Each face is cut into triangles that
/// are seen within a small angle; each brings the radiance that the sky has behind its middle, times its
/// irradiance in closed form (polygon_irradiance) and what media leave of the light from its middle; nothing
/// where an obstacle is before it. The beams of a sky, some 10 degrees apart, go through a small window by
/// chance; this does not depend on where they go.
class SkyIrradiance {
 public:
  /// The sky must show its radiance; there must be no mirrors. The arguments must outlive it.
  SkyIrradiance(const SkySource& sky, const LightPaths& paths);

  const SkySource& sky() const { return sky_; }
  /// Adds to irradiance [band], on the side of a plane that the unit vector `normal` points to, and to
  /// fluence [band].
  void add(const PointInCell& at, const Vec3& normal, std::span<double> irradiance,
           std::span<double> fluence) const;

 private:
  const SkySource& sky_;
  const LightPaths& paths_;
  std::vector<FaceIndex> faces_;
};

}  // namespace etendue
