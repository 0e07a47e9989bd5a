// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

namespace etendue {

/// How the equation of patches is solved.
enum class RadiosityMethod { gathering, shooting, direct, hierarchical };

}  // namespace etendue
