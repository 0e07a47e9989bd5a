// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "app/case/case.h"
#include "solver/uncollided/lights/light_setup.h"

namespace etendue {

/// Throws InputError where a case asks a method without a direction set for what needs one: an exact
/// radiance, of which `why_not_exact` says the reason, or the radiance of an ordinate.
void refuse_what_needs_ordinates(const Case& input, const std::string& method,
                                 const std::string& why_not_exact);

/// Throws InputError where a case has directions for light that collides first and no light that does.
void require_lights_of_first_collided(const Case& input, const LightSetup& lights);

}  // namespace etendue
