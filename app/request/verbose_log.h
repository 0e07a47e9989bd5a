// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <ostream>

#include "app/request/command_line.h"
#include "base/log.h"

namespace etendue {

/// Passes what long computations have to say on to `err` where that was asked for.
inline Log verbose_log(const CaseRequest& request, std::ostream& err) {
  if (!request.verbose) return {};
  return [&err](std::string_view line) { err << line << '\n'; };
}

}  // namespace etendue
