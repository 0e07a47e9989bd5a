// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/uncollided/projection/cell_light.h"

namespace etendue {

/// Adds the directions from which light with an extent comes to where it scatters in a cell: those in which
/// rays find it at points of the cell, with the shares that they bring there, so that for each shape function
/// and band they add up to `power` [4][band], the integrals of all that scatters. Where rays find nothing of
/// what the cell gets, light comes as in empty space.
void add_extended_collisions(const LightPaths& paths, const LightSource& source, const LitCell& cell,
                             std::span<const double> power, LightBeams& beams, DirectionalMoments& sum);

}  // namespace etendue
