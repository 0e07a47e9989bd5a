// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

namespace etendue {

/// The code with which TetGen gave up in a process that ended with exit_code, or 0 where it did not.
int tetgen_code(int exit_code);

}  // namespace etendue
