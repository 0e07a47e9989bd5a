// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "app/request/exit_code.h"

namespace etendue {

/// The whole program: does what `arguments` (without the program's name) ask. Faults become one line each on
/// `err`; nothing is thrown.
ExitCode run_command(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err);

}  // namespace etendue
