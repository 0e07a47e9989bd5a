// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "app/case/case.h"
#include "app/case/keys/section.h"

namespace etendue {

/// The table [exact]. The case's media, walls, cameras and sensors must have been read: what emits or
/// reflects beside the exact radiance is a fault, and so is what looks along rays, which do not see its
/// source.
void read_exact(Section exact, Case& result);

}  // namespace etendue
