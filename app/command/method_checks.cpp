// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/command/method_checks.h"

#include <fmt/format.h>

#include "mesh/base/errors.h"

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

}  // namespace etendue
