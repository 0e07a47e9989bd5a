// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "app/write/result/run_result.h"

namespace etendue {

/// What a person reads of a solution by radiosity: patches, checks of the factors, passes. Empty for others.
std::string radiosity_text(const RunResult& result);

}  // namespace etendue
