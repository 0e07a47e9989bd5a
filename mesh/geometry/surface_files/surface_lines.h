// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace etendue {

/// The words of a text file, line by line. Comments begin with '#'; empty lines are passed over.
class SurfaceLines {
 public:
  /// Throws FileError where the file cannot be opened.
  explicit SurfaceLines(const std::filesystem::path& path);

  /// Goes to the next line that has words; false at the end.
  bool next();
  /// The same, where the end is a fault: `expected` says what should have come.
  void require(std::string_view expected);

  const std::vector<std::string_view>& words() const { return words_; }
  /// What stands behind the first word, without spaces around it.
  std::string_view rest() const;
  /// A word of the line as a number; a missing or malformed one is a fault.
  int integer(std::size_t word, std::string_view what) const;
  double number(std::size_t word, std::string_view what) const;
  /// Throws InputError with file and line.
  [[noreturn]] void fail(const std::string& problem) const;

 private:
  std::string_view word(std::size_t index, std::string_view what) const;

  std::string file_;
  std::string text_;
  std::size_t position_ = 0;
  int line_ = 0;
  std::vector<std::string_view> words_;
};

/// The whole content of a file. Throws FileError where it cannot be read.
std::string file_content(const std::filesystem::path& path);

}  // namespace etendue
