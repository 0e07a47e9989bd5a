// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>

#include "app/case/section.h"
#include "solver/problem/angular_space.h"
#include "solver/problem/phase_function.h"

namespace etendue {

/// What a phase function is read with. Files that it names are found beside the case.
struct PhaseContext {
  AngularSpace space;
  const std::filesystem::path& case_folder;
};

/// A table [media.NAME.phase].
PhaseFunction read_phase(Section phase, const PhaseContext& context);

}  // namespace etendue
