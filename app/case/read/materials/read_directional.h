// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "app/case/read/materials/read_matter.h"

namespace etendue {

/// Whether the medium is one of leaves, flakes or a kernel.
bool is_directional(const Section& section);

/// Reads leaves, flakes or a kernel: what they are, and the means of absorption and scattering over
/// directions that go with them (those of a kernel follow when the mesh is there).
void read_directional(Section& section, const MatterContext& context, MediumCase& medium);

}  // namespace etendue
