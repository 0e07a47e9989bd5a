// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "app/write/result/run_result.h"

namespace etendue {

// What a person reads of a solution by photons, beside what all methods say; empty for other methods.

/// Histories, errors, figures of merit and speed.
std::string photons_text(const RunResult& result);
/// Balance, walls, regions and probes: the standard errors of what was printed.
std::string errors_text(const RunResult& result);

}  // namespace etendue
