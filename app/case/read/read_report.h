// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "app/case/case.h"
#include "app/case/keys/section.h"

namespace etendue {

std::vector<Probe> read_probes(Section& top);

/// The table [output]; the directory is by default the case's name, in the working directory.
OutputCase read_output(Section output, const std::filesystem::path& case_file);

/// Reports what does not go with a mean over rotated sets of directions.
void check_rotations(Section directions, Section output, const Case& result);
/// Reports what does not go with a set of its own for light that has collided once.
void check_first_collided(Section directions, const Case& result);
/// Reports ordinates to be kept that the direction set does not have.
void check_ordinates(Section output, const Case& result);

}  // namespace etendue
