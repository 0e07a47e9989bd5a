// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/vec3.h"

namespace etendue {

/// A file of OpenFOAM, word by word; lists may be binary where the header says so. Whatever is wrong throws
/// InputError with file and line.
class FoamFile {
 public:
  /// Reads the header, whose class must be one of `classes`. Throws FileError where the file cannot be read.
  FoamFile(const std::filesystem::path& path, const std::vector<std::string_view>& classes);

  const std::string& class_name() const { return class_name_; }
  std::size_t size() const { return text_.size(); }  ///< [bytes]
  bool is_binary() const { return binary_; }

  /// The next word, number, string or one of ( ) { } ; - empty at the end of the file.
  std::string_view token();
  /// The next token, left where it is.
  std::string_view peek();
  /// Skips a token that must be this.
  void expect(std::string_view wanted);
  /// Skips the rest of an entry of a dictionary: up to its `;`, or its `{ }`.
  void skip_entry();

  std::int64_t integer(std::string_view what, std::int64_t least, std::int64_t most);
  /// Number of things that follow, each of at least so many bytes: more than the file can hold is a fault.
  std::size_t count(std::string_view what, std::size_t least_bytes);

  /// List of integers in this range, at most `most_entries`. Words before its length, as List<label>, are
  /// skipped.
  std::vector<int> labels(std::string_view what, std::int64_t least, std::int64_t most,
                          std::size_t most_entries);
  std::vector<Vec3> vectors(std::string_view what);

  [[noreturn]] void fail(const std::string& problem) const;

 private:
  void read_header(const std::vector<std::string_view>& classes);
  void read_architecture(std::string_view text);
  void skip_blanks();
  void skip_to_end_of_comment(std::string_view end);
  double number(std::string_view what);
  std::int64_t binary_label();
  double binary_scalar();
  std::string_view raw(std::size_t size);

  std::string file_;
  std::string text_;
  std::size_t next_ = 0;
  int line_ = 1;
  std::string class_name_;
  bool binary_ = false;
  std::size_t label_size_ = 4, scalar_size_ = 8;  ///< of binary lists [bytes]
};

}  // namespace etendue
