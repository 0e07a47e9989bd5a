// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

namespace etendue {

/// Enough for lobes that are not seen to be made of rays once pixels have four of them.
inline constexpr int default_glossy_rays = 16;

}  // namespace etendue
