// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdio>
#include <functional>
#include <string>
#include <string_view>

namespace etendue {

/// How a child process ended and what it left.
struct ChildOutcome {
  int exit_code = 0;   ///< what the work returned
  int signal = 0;      ///< the signal that killed it; 0: it ended by itself
  std::string result;  ///< the bytes that the work wrote
};

/// The memory of this machine [bytes].
std::size_t physical_memory();

/// Runs work in a child process: a library that may end the process, trip an assertion or run out of memory
/// cannot take this one along. The work gets no more memory than the machine has. What the work prints on
/// standard output and standard error is given to on_line, line by line, as it comes. The work writes its
/// result to the file that it is given. Throws std::runtime_error where the system refuses a process.
ChildOutcome run_in_child(const std::function<int(std::FILE* result)>& work,
                          const std::function<void(std::string_view)>& on_line);

}  // namespace etendue
