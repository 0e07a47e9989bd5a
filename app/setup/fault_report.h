// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <exception>
#include <string>

#include "app/request/exit_code.h"

namespace etendue {

/// The exit code of a command that a fault has ended, and the line for standard error.
struct FaultReport {
  ExitCode code;
  std::string text;
};

FaultReport report_of(const std::exception& fault);

}  // namespace etendue
