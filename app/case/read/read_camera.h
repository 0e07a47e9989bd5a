// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "app/case/case.h"
#include "app/case/keys/section.h"

namespace etendue {

/// Of a view and `up` that are all but parallel rounding would decide what points up.
inline constexpr double smallest_sine_of_up = 1e-6;

std::vector<CameraCase> read_cameras(Section& top);

}  // namespace etendue
