// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/write/result/run_result.h"

namespace etendue {

/// Wall-clock seconds of the stages of a run, by name and in their order; no time is in two of them, and the
/// last, "total", is that of all up to the end of the writing.
std::vector<std::pair<std::string, double>> stage_seconds(const RunResult& result, double writing);

}  // namespace etendue
