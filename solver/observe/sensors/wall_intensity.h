// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/parallel/stage_observer.h"
#include "solver/observe/radiance/ray_radiance.h"
#include "solver/observe/sensors/measurement.h"

namespace etendue {

/// The frame of a goniometric diagram: the polar angle is that to the wall's mean normal out of the domain,
/// the azimuth runs from the x axis, projected on the wall (of a wall across x: from the y axis),
/// counterclockwise as seen from outside.
struct WallFrame {
  Vec3 axis;
  Vec3 across;
  Vec3 up;

  WallFrame(const TetrahedralMesh& mesh, int wall);
  Vec3 direction(double polar, double azimuth) const;  ///< [rad]
};

/// Polar angles from 0 to pi/2 and azimuths from 0 to 2 pi, without its end [rad].
double polar_angle(int k, int count);
double azimuth_angle(int k, int count);

/// Radiant intensity [power/sr] of the light that leaves the domain by a wall,
///
///     I(w) = integral over the wall of L(x, w) w.n dA,
///
/// by three points of degree 2 on each of its faces, L along rays. Light of points and spots that goes out
/// straight adds what they send in that direction, times its transmittance; a sun's has no intensity. Rows
/// are polar angles, columns azimuths. The same bits for any number of threads. A counter counts
/// intensity_rays() and may stop it; then the numbers are not complete.
GridReading wall_intensity(const LightSetup& lights, const RayRadiance& scene, int wall, int azimuths,
                           int polar_angles, int threads, StageCounter* counter = nullptr);

/// Rays of so many directions.
std::size_t intensity_rays(const TetrahedralMesh& mesh, int wall, std::size_t directions);

}  // namespace etendue
