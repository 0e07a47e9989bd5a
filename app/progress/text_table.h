// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace etendue {

/// Where the text of a column stands.
enum class Align { left, right };

/// A table for people: columns as wide as their widest text, two spaces between them.
class TextTable {
 public:
  /// `names` of the columns; as many alignments.
  TextTable(std::vector<std::string> names, std::vector<Align> alignment);
  void add_row(std::vector<std::string> row);
  bool empty() const { return rows_.size() < 2; }
  /// One line for each row, each beginning with two spaces.
  std::string text() const;

 private:
  std::vector<Align> alignment_;
  std::vector<std::vector<std::string>> rows_;  ///< the names first
};

/// Six significant digits.
std::string number(double value);

/// Digits down to the second of the standard error, at most six; of a value without an error (0) six.
std::string number(double value, double error);

}  // namespace etendue
