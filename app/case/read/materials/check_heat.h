// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "app/case/case.h"
#include "base/errors.h"

namespace etendue {

/// Reports what a case asks beside temperatures that follow by iteration and cannot have in this version.
void check_heat(const Case& input, std::vector<Fault>& faults);

}  // namespace etendue
