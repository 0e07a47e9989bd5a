// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "app/case/false_color.h"
#include "app/case/keys/section.h"

namespace etendue {

/// The table `false_color` of a camera.
FalseColor read_false_color(Section section);

}  // namespace etendue
