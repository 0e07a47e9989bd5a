// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>

#include "base/random/drawn_numbers.h"
#include "mesh/tetrahedra/tetrahedral_mesh.h"
#include "solver/materials/kernels/directional_scattering.h"

namespace etendue {

/// Draws where light goes that is scattered by a medium which depends on the directions themselves: a
/// direction v as likely as k(w -> v) dv is. May be used by several threads at a time.
class DirectionSampler {
 public:
  virtual ~DirectionSampler() = default;
  /// `travel` is the unit vector w. Something must be scattered out of it. It is given back where the light
  /// has met nothing.
  virtual Vec3 scattered(CellIndex cell, const Vec3& travel, DrawnNumbers& random) const = 0;
  /// [1/length] at which light must be asked whether it has met something; 0: the scattering coefficient.
  virtual double meeting_rate() const { return 0; }
};

/// Of leaves and flakes; null for others.
///
/// Of leaves the normal n that the light meets is drawn by rejection, as likely as g_L(n) |w.n|, and
/// Lambert's law about it then: exactly Ross's kernel. Flakes are mirrors whose normals h = C u/|C u|, C^2 =
/// S, are those of an ellipsoid, seen as |w.h| D(h) dh = |C w.u| du/pi: u is drawn about C w as Lambert's law
/// says (Heitz et al. 2015, section 4).
std::unique_ptr<DirectionSampler> make_direction_sampler(const DirectionalScattering& scattering);

}  // namespace etendue
