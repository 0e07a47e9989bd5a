// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>

#include "solver/photons/drawn_numbers.h"
#include "solver/problem/directional_scattering.h"

namespace etendue {

/// Draws where light goes that is scattered by matter which depends on the directions themselves: a direction
/// v as likely as k(w -> v) dv is. May be used by several threads at a time.
class DirectionSampler {
 public:
  virtual ~DirectionSampler() = default;
  /// `travel` is the unit vector w. Something must be scattered out of it.
  virtual Vec3 scattered(const Vec3& travel, DrawnNumbers& random) const = 0;
};

/// Of leaves and flakes; null for others.
///
/// Of leaves the normal n that the light meets is drawn by rejection, as likely as g_L(n) |w.n|, and
/// Lambert's law about it then: exactly Ross's kernel. Flakes are mirrors whose normals h = C u/|C u|, C^2 =
/// S, are those of an ellipsoid, seen as |w.h| D(h) dh = |C w.u| du/pi: u is drawn about C w as Lambert's law
/// says (Heitz et al. 2015, section 4).
std::unique_ptr<DirectionSampler> make_direction_sampler(const DirectionalScattering& scattering);

}  // namespace etendue
