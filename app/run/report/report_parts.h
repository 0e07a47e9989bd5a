// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "app/progress/text_table.h"
#include "app/run/report/run_report.h"

namespace etendue {

/// Rows beyond which a table is left to its CSV file.
inline constexpr std::size_t longest_report_table = 40;

inline std::string titled(const std::string& title, const TextTable& table) {
  return "\n" + title + "\n" + table.text();
}

inline const std::string& band_name(const RunResult& result, std::size_t band) {
  return result.problem.bands().names[band];
}

}  // namespace etendue
