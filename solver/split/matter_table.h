// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>

#include "solver/angle/direction_set.h"
#include "solver/lights/light_setup.h"

namespace etendue {

/// Where matter that depends on the directions scatters the light of a source, at the vertices of the cells
/// that have matter of this kind (RayMatter): [ordinate][vertex] [1/sr], the sum over the beams of phi_k
/// k(w_k -> w_m) over its sum over the set, so that the energy is kept. Other vertices are left alone, and so
/// is one that is itself the light.
void tabulate_matter(const LightSetup& lights, const LightSource& source, int kind,
                     const DirectionSet& directions, int threads, std::span<double> table);

}  // namespace etendue
