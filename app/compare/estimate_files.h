// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>

#include "app/compare/error_estimate.h"

namespace etendue {

/// Writes estimate.csv beside the results of a run of this process, and the estimate into their summary.json;
/// nothing where another run has replaced them. Signals are to be noted only, so that the files become whole.
/// Throws FileError.
void write_estimate(const ErrorEstimate& estimate, const std::filesystem::path& directory);

}  // namespace etendue
