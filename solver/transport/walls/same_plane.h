// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

namespace etendue {

/// Normals of one flat wall differ by rounding only.
inline constexpr double same_plane = 1e-10;

}  // namespace etendue
