// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include <etendue/export.h>

namespace etendue {
ETENDUE_INTERFACE_BEGIN
/// The whole program: does what `etendue ARGUMENTS...` does and returns its exit code. While a run lasts it
/// handles SIGINT and SIGTERM for the whole process, and may end the process: meant for programs that do
/// nothing else.
ETENDUE_EXPORT int run_command(const std::vector<std::string>& arguments, std::ostream& out,
                               std::ostream& err);

/// Version of the library: "0.1.0".
ETENDUE_EXPORT std::string version();

ETENDUE_INTERFACE_END
}  // namespace etendue
