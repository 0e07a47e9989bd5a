// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
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

/// Memory that reading a file may take [bytes], beside that of the program: far more than the values of a
/// sound file of this size, compressed too, and far less than a damaged one asks for.
std::size_t memory_to_read(const std::filesystem::path& file);

/// For the work of a child process: ends it by SIGXCPU after so many seconds of the processor.
void limit_processor_seconds(double seconds);

/// Runs work in a child process: a library that may end the process, trip an assertion or run out of memory
/// cannot take this one along. The work gets no more memory than `memory` [bytes] and the machine have. What
/// the work prints on standard output and standard error is given to on_line, line by line, as it comes; what
/// on_line throws ends the child and is passed on. The work writes its result to the file that it is given, a
/// pipe. Throws FileError where the system refuses a process or a pipe.
ChildOutcome run_in_child(const std::function<int(std::FILE* result)>& work,
                          const std::function<void(std::string_view)>& on_line,
                          std::size_t memory = physical_memory());

}  // namespace etendue
