// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "app/case/case.h"

namespace etendue {

/// Adds a fault for each medium, wall and light that does not suit temperatures that change with time, or
/// that has keys for it in a case where they do not.
void check_heat_in_time(const Case& input, std::vector<Fault>& faults);

}  // namespace etendue
