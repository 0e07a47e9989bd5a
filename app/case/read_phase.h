// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>

#include "app/case/section.h"
#include "solver/problem/phase_function.h"

namespace etendue {

/// A table [media.NAME.phase]. Files that it names are found beside the case.
PhaseFunction read_phase(Section phase, const std::filesystem::path& case_folder);

}  // namespace etendue
