// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace etendue::test {

/// A table of a result file: a line of names of columns, then rows. Commas part fields, in quotes too. What
/// is not there throws.
class CsvTable {
 public:
  explicit CsvTable(const std::string& text);

  const std::vector<std::vector<std::string>>& rows() const& { return rows_; }
  std::vector<std::vector<std::string>> rows() && { return std::move(rows_); }
  /// Fields of a column, and its numbers.
  std::vector<std::string> column(const std::string& name) const;
  std::vector<double> numbers(const std::string& name) const;
  /// A number of the first row that begins with these fields.
  double number(const std::vector<std::string>& beginning, const std::string& name) const;

 private:
  std::size_t index_of(const std::string& name) const;

  std::vector<std::string> names_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace etendue::test
