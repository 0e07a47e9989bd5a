// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "app/case/case.h"
#include "app/setup/run_options.h"
#include "solver/problem/problem.h"

namespace etendue {

/// Of a run by photons with its pictures.
RunMemory photon_run_memory(const Case& input, const Problem& problem);

}  // namespace etendue
