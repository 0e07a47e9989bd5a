// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

namespace etendue {

/// Version of the program.
std::string program_version();

}  // namespace etendue
