// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace etendue {

/// When and by which command a run began.
struct RunRecord {
  std::string command_line;  ///< as a shell takes it; empty where no command line began the run
  std::chrono::sys_seconds begun = {};
};

/// Date and time in UTC by ISO 8601: 2026-11-24T18:25:39Z.
std::string iso_date(std::chrono::sys_seconds time);

/// Name of this machine; "unknown" where the system does not tell.
std::string host_name();

/// Program and arguments in one line that a POSIX shell takes apart again in the same way.
std::string shell_line(const std::string& program, const std::vector<std::string>& arguments);

}  // namespace etendue
