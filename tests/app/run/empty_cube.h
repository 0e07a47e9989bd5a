// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

namespace etendue::test {

/// A case for radiosity: a cube with a non-participating medium, a bright floor, red side walls, a probe that
/// looks down.
std::string empty_cube();

}  // namespace etendue::test
