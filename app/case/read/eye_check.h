// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "app/case/case.h"
#include "app/case/keys/value_check.h"

namespace etendue {

/// Reports glare sensors and pictures of luminance in a case whose bands the eye does not see, or whose units
/// are not those of the SI.
void check_seen_by_eye(const Case& input, Faults& faults);

}  // namespace etendue
