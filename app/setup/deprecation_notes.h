// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <ostream>

#include "app/case/case.h"

namespace etendue {

/// Writes a line for each key that has its former name in the case.
inline void write_deprecations(const Case& input, std::ostream& out) {
  for (const std::string& line : input.deprecations) out << line << '\n';
  out << std::flush;
}

}  // namespace etendue
