// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "base/vec3.h"

namespace etendue {

/// A word of a broken file, made fit to be shown on one line.
std::string shown_word(std::string_view word);

/// The whole of a file. Throws FileError where it cannot be read.
std::string read_bytes(const std::filesystem::path& path);

/// A text file of words, line by line. Whatever is wrong throws InputError with file and line.
class TextLines {
 public:
  /// What follows `comment` on a line is left out; '\0' for none. Throws FileError where the file cannot be
  /// read, InputError where it is binary.
  explicit TextLines(const std::filesystem::path& path, char comment = '\0');

  /// Goes to the next line that has words; false at the end of the file.
  bool next();
  /// The same; the end of the file is a fault.
  void next(std::string_view expected);

  /// The next word of the line; empty after the last.
  std::string_view word();
  /// Rest of the line.
  std::string_view rest() const { return rest_; }

  std::int64_t integer(std::string_view what, std::int64_t least, std::int64_t most);
  /// An integer of any size.
  std::int64_t integer(std::string_view what);
  double number(std::string_view what);
  Vec3 point();
  /// Number of things that follow, each at least two bytes: more than the file can hold is a fault, so that a
  /// wrong number does not take all memory.
  std::size_t count(std::string_view what);

  [[noreturn]] void fail(const std::string& problem) const;
  /// `what = value: problem`
  [[noreturn]] void fail(std::string_view what, std::string_view value, const std::string& problem) const;

  int line() const { return line_; }
  const std::string& file() const { return file_; }

 private:
  std::string_view needed_word(std::string_view what, std::string_view kind);

  std::string file_;
  std::string text_;
  char comment_;
  std::size_t next_ = 0;  ///< where the next line starts
  int line_ = 0;
  std::string_view rest_;
};

}  // namespace etendue
