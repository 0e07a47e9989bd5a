// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/generation/tetgen_termination.h"

#include <unistd.h>

#include <cstdio>

class tetgenmesh;
void terminatetetgen(tetgenmesh* mesh, int code);

namespace {

/// Added to TetGen's codes, to tell them from the exit codes of a process.
constexpr int kFirstExitCode = 100;
constexpr int kLargestCode = 10;

}  // namespace

// TetGen 1.5.0 frees its memory before it throws, and again while the exception passes its destructor:
// the process dies of that and the reason is lost. The function is a weak symbol of the shared library, so
// this one takes its place, and ends the child process with the reason instead.
void terminatetetgen(tetgenmesh* /*mesh*/, int code) {
  std::fflush(stdout);
  _exit(kFirstExitCode + code);
}

namespace etendue {

int tetgen_code(int exit_code) {
  const int code = exit_code - kFirstExitCode;
  return code > 0 && code <= kLargestCode ? code : 0;
}

}  // namespace etendue
