// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cmath>

#include "base/random/random_stream.h"
#include "solver/photons/kernel/photon_scene.h"

namespace etendue {

// How photons change direction.

/// A point of the unit circle at an angle that is uniform over it: within a quarter by series up to pi/4, off
/// by 1e-15, the quarter by the first two bits.
ETENDUE_PHOTON_INLINE void unit_circle(std::uint32_t word, double& cosine, double& sine) {
  constexpr double part = 1.5707963267948966 / 1073741824.0;
  const double t = (static_cast<double>(word & 0x3FFFFFFF) + 0.5) * part - 0.78539816339744831;
  const double s = t * t, q = s * s, o = q * q;
  constexpr double a[] = {1,          -1. / 2,       1. / 24,        -1. / 720,
                          1. / 40320, -1. / 3628800, 1. / 479001600, -1. / 87178291200.};
  constexpr double b[] = {1,           -1. / 6,        1. / 120,         -1. / 5040,
                          1. / 362880, -1. / 39916800, 1. / 6227020800., -1. / 1307674368000.};
  const double c =
      (a[0] + a[1] * s) + (a[2] + a[3] * s) * q + ((a[4] + a[5] * s) + (a[6] + a[7] * s) * q) * o;
  const double v =
      t * ((b[0] + b[1] * s) + (b[2] + b[3] * s) * q + ((b[4] + b[5] * s) + (b[6] + b[7] * s) * q) * o);
  const bool swap = (word & 0x40000000) != 0;
  const double sign = (word & 0x80000000) != 0 ? -1.0 : 1.0;
  cosine = sign * (swap ? -v : c);
  sine = sign * (swap ? c : v);
}

/// The direction mu w + u a + v b in a frame (a, b, w) without branches (Duff et al. 2017); (mu, u, v) is a
/// unit vector. The length is put right to first order, so that errors do not grow.
ETENDUE_PHOTON_INLINE void turn_by(double (&w)[3], double mu, double u, double v) {
  const double sign = std::copysign(1.0, w[2]);
  const double a = -1 / (sign + w[2]), b = w[0] * w[1] * a;
  double next[3] = {mu * w[0] + u * (1 + sign * w[0] * w[0] * a) + v * b,
                    mu * w[1] + u * (sign * b) + v * (sign + w[1] * w[1] * a),
                    mu * w[2] - u * (sign * w[0]) - v * w[1]};
  const double square = next[0] * next[0] + next[1] * next[1] + next[2] * next[2];
  const double scale = 1.5 - 0.5 * square;
  for (int axis = 0; axis < 3; ++axis) w[axis] = scale * next[axis];
}

/// The direction at the cosine mu from w, at the given azimuth.
ETENDUE_PHOTON_INLINE void turn(double (&w)[3], double mu, double azimuth_cosine, double azimuth_sine) {
  const double radius = 1 - mu * mu;
  const double sine = radius > 0 ? std::sqrt(radius) : 0.0;
  turn_by(w, mu, sine * azimuth_cosine, sine * azimuth_sine);
}

/// The same in the plane z = const: sine is positive to the left.
ETENDUE_PHOTON_INLINE void turn_in_plane(double (&w)[3], double mu, double sine) {
  const double x = mu * w[0] - sine * w[1], y = mu * w[1] + sine * w[0];
  const double scale = 1.5 - 0.5 * (x * x + y * y);
  w[0] = scale * x;
  w[1] = scale * y;
}

/// Leaves a wall as Lambert says, or as from a mirror. The first random word is already used.
ETENDUE_PHOTON_INLINE void reflect(const PhotonSceneView& scene, const PhotonFace& wall, bool diffusely,
                                   const std::uint32_t (&word)[4], double (&w)[3]) {
  const double* n = wall.normal;
  if (!diffusely) {
    const double twice = 2 * (w[0] * n[0] + w[1] * n[1] + w[2] * n[2]);
    for (int axis = 0; axis < 3; ++axis) w[axis] -= twice * n[axis];
    return;
  }
  if (scene.in_plane) {
    const double along = 2 * uniform(word[1]) - 1, out = std::sqrt(1 - along * along);
    for (int axis = 0; axis < 3; ++axis) w[axis] = out * n[axis] + along * wall.tangent[axis];
    return;
  }
  double c, s;
  unit_circle(word[2], c, s);
  for (int axis = 0; axis < 3; ++axis) w[axis] = n[axis];
  turn(w, std::sqrt(uniform(word[1])), c, s);
}

}  // namespace etendue
