// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "app/request/exit_code.h"
#include "base/parallel/rank_group.h"

namespace etendue {

/// The whole program: does what `arguments` (without the program's name) ask. Faults become one line each on
/// `err`; nothing is thrown. `ranks` are the processes that do the same, null where this one is alone: they
/// share a run by ordinates or photons, and all else is refused.
ExitCode run_command(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err,
                     RankGroup* ranks = nullptr);

}  // namespace etendue
