// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/setup/method_checks.h"

#include <fmt/format.h>

#include "base/errors.h"

namespace etendue {

void refuse_what_needs_ordinates(const Case& input, const std::string& method,
                                 const std::string& why_not_exact) {
  if (input.exact)
    throw InputError(fault_at(input.exact->origin, "", why_not_exact + "; use solve.method = \"auto\""));
  if (!input.output.radiance_ordinates.empty())
    throw InputError(fault_at(
        input.output.origin, "",
        fmt::format("asks for the radiance of an ordinate, and {} none; take it out of output.fields",
                    method)));
}

void require_lights_of_first_collided(const Case& input, const LightSetup& lights) {
  if (!input.first_collided || !lights.empty()) return;
  throw InputError(fault_at(input.first_collided->origin, "",
                            "nothing of this case is a light that is followed along rays, so nothing "
                            "collides first; use uncollided = true where light comes from, or no "
                            "first_collided"));
}

}  // namespace etendue
