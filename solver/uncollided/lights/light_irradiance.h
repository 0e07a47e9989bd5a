// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "solver/uncollided/closed_form/emitter_tree.h"
#include "solver/uncollided/lights/light_setup.h"
#include "solver/uncollided/lights/sky_irradiance.h"

namespace etendue {

/// Light at a point, [band] [power/length^2].
struct UncollidedAtPoint {
  std::vector<double> irradiance;  ///< on the side of a plane that its normal points to
  std::vector<double> fluence;
};

/// What lights bring to a point before the first collision, exact as far as it is known in closed form. A
/// flat light brings
///
///     E = L E_polygon - sum over its beams of (1 - T) phi w.n,                                     (1)
///
/// the irradiance of its triangles in empty space, closed (polygon_irradiance), less what media and obstacles
/// keep of the beams (transmittance T, 0 in the shadow) that it is cut into. Where nothing is in between
/// that is exact to rounding; else the error is that of the beams times the part that is lost. The same holds
/// of the fluence, with solid angles, and of the light's images behind mirrors, of which E_polygon is taken
/// whole and what the edges of a mirror cut off is lost like that behind an obstacle. Skies are
/// integrated over the faces by which they come in (SkyIrradiance) where not all of their beams arrive.
/// Lights of other kinds are the sums of their beams: exact for points, spots and the sun.
class LightIrradiance {
 public:
  /// The lights must outlive it.
  explicit LightIrradiance(const LightSetup& lights);

  /// `normal` is a unit vector.
  UncollidedAtPoint at(const PointInCell& point, const Vec3& normal) const;

  /// Adds (1) for one light. `seen` are its beams through media and past obstacles, `clear` those of empty
  /// space at the same detail; without these, as for lights that are not flat, the sum over its beams is
  /// added.
  void add(const LightSource& source, const Vec3& position, const Vec3& normal, const LightBeams& seen,
           const LightBeams& clear, UncollidedAtPoint& light) const;

 private:
  void add_sky(const SkyIrradiance& sky, const PointInCell& point, const Vec3& normal,
               UncollidedAtPoint& light) const;
  /// What would arrive of one of its images in empty space.
  void add_clear(std::span<const EmitterPart> flat, MirrorSet mirrors, const Vec3& position,
                 const Vec3& normal, UncollidedAtPoint& light) const;

  const LightSetup& lights_;
  std::vector<MirrorSet> images_;                    ///< behind which flat lights are seen
  std::vector<std::optional<SkyIrradiance>> skies_;  ///< [source] of skies without mirrors
};

}  // namespace etendue
