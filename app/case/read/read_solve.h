// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "app/case/case.h"
#include "app/case/keys/section.h"

namespace etendue {

/// The tables [directions], [space] and [solve].
void read_directions(Section directions, Case& result);
void read_space(Section space, SolveOptions& options);
/// The table [radiosity]; it may stand beside another method.
void read_radiosity(Section radiosity, bool chosen, Case& result);
/// The table [photon_map], after [solve]; it may stand beside another method.
void read_photon_map(Section map, Case& result);
void read_solve(Section solve, const std::filesystem::path& case_folder, Case& result);

}  // namespace etendue
