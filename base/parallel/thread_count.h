// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <omp.h>

namespace etendue {

/// Threads to use where `asked` are asked for; 0: one for each core.
inline int thread_count(int asked) { return asked > 0 ? asked : omp_get_num_procs(); }

}  // namespace etendue
