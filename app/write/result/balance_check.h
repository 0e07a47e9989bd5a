// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "app/write/result/run_result.h"

namespace etendue {

/// Whether a band neither loses nor gains light: the residual of its balance is at most
/// solve.balance_tolerance, of photons beside three standard errors of it.
bool is_balanced(const RunResult& result, std::size_t band);

/// Whether all bands are balanced.
bool is_balanced(const RunResult& result);

/// One line that names the bands that are not balanced, and their residuals; empty where all are.
std::string balance_warning(const RunResult& result);

/// One line that names the bands that are balanced within solve.balance_tolerance, but not within three
/// tenths of it (3e-3 where nothing else is asked for); empty where there are none.
std::string balance_caution(const RunResult& result);

}  // namespace etendue
