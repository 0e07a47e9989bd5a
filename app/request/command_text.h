// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

namespace etendue {

/// What the help of the program ends with: examples of all commands, and the exit codes.
extern const char* const command_examples;

/// The examples of one command.
std::string examples_of(const std::string& command);

/// Empty, or what is wrong with a number of threads.
std::string whole_number(const std::string& text);

}  // namespace etendue
