// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

namespace etendue {

/// What the program returns to its caller.
enum class ExitCode {
  done = 0,
  not_converged = 1,   ///< or not balanced; results are written and marked so, unless they are not finite
  input_error = 2,     ///< case, mesh or command line are wrong, or need more memory than there is
  file_error = 3,      ///< a file could not be read or written
  internal_error = 4,  ///< a fault of the program
  interrupted = 130    ///< by a signal; as shells have it for SIGINT
};

}  // namespace etendue
