// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "app/case/case.h"

namespace etendue {

/// Gives light that has collided once a finer set of directions, where a spot shines into a medium that
/// scatters into a lobe narrower than the directions are apart: light scattered once leaves the cone at
/// angles that they do not resolve. Nothing where the case chooses (`chosen`), or where such a set is not
/// possible.
void choose_first_collided(bool chosen, Case& input);

}  // namespace etendue
