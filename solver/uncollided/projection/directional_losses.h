// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/uncollided/projection/cell_light.h"

namespace etendue {

/// Absorption and scattering in a cell of light that comes from many directions, where the medium
/// attenuates each differently: for each shape function
///
///     integral over K of shape sum over k of s(w_k) phi_k dV = s_i integral over K of shape phi dV,
///
/// with s_i the mean over the directions w_k in which rays find light at points of the cell. `moments` hold
/// the fluence phi.
void add_directional_losses(const LightPaths& paths, const LightSource& source, const LitCell& cell,
                            LightBeams& beams, NodalMoments& moments);

}  // namespace etendue
