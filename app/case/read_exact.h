// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "app/case/case.h"
#include "app/case/section.h"

namespace etendue {

/// The table [exact]. The case's media and walls must have been read: what emits or reflects beside the exact
/// radiance is a fault.
void read_exact(Section exact, Case& result);

}  // namespace etendue
