// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "app/case/case.h"

namespace etendue {

/// What the pictures and the probes of a case take [bytes].
double output_memory(const Case& input);

/// Throws InputError where the pictures and the probes of a case need more memory than there is, of this
/// machine or by a limit of the process (ulimit -v), with the cameras and probes that take the most.
void check_output_memory(const Case& input);

}  // namespace etendue
