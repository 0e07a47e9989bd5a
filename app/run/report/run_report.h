// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "app/write/results.h"

namespace etendue {

// What a person reads of a run, part by part; every part ends with a line break, or is empty.

/// Choices and their reasons, and how each band converged.
std::string convergence_text(const RunResult& result);
/// The balance of each band.
std::string balance_text(const RunResult& result);
/// The balance of uncollided light, where there are lights.
std::string uncollided_text(const RunResult& result);
/// Walls and regions.
std::string powers_text(const RunResult& result);
/// Heat that walls and regions exchange, where the case has temperatures.
std::string heat_text(const RunResult& result);
/// Probes, where they are few.
std::string probes_text(const RunResult& result);
/// Light that changes with time, where the case asks for it and numbers are few.
std::string time_text(const RunResult& result);
/// The error against the exact solution, where the case says what it is.
std::string exact_text(const RunResult& result);
/// Negative values and lagged faces, where there are any.
std::string cautions_text(const RunResult& result);
/// Time of the stages, and the files with how to open them.
std::string closing_text(const RunResult& result, const WrittenResults& written);

}  // namespace etendue
