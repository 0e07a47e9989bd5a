// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "app/case/case.h"
#include "app/case/keys/section.h"

namespace etendue {

/// Reads [accuracy], which is there; needs the probes and sensors that it names.
void read_accuracy(Section accuracy, bool sets_tolerance, Case& result);

}  // namespace etendue
