// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace etendue::test {

/// A line of a table in validation/reference with quoted parameters.
struct ReferenceRow {
  std::string name;
  std::vector<double> parameters;  ///< the numbers in the quotes
  std::vector<double> values;      ///< the columns behind them
};

/// All lines of a file of validation/reference.
std::vector<ReferenceRow> reference_rows(const std::string& file);

}  // namespace etendue::test
