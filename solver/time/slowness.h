// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

namespace etendue {

/// Slowness n / c of light in the regions of a problem [time/length].
using Slowness = std::vector<double>;

}  // namespace etendue
