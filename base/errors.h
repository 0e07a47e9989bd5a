// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <compare>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace etendue {

/// Where a value came from: the file, the line (from 1; 0 where there is none) and its dotted key.
struct Origin {
  std::string file;
  int line = 0;
  std::string key;
};

/// One thing that is wrong with what the user gave.
struct Fault {
  std::string file;  ///< empty where no file is concerned
  int line = 0;      ///< from 1; 0 where no line is concerned
  std::string text;  ///< `key = value: problem (why); what is accepted`
  auto operator<=>(const Fault&) const = default;
};

/// A fault of the value that came from `origin`; `value` may be empty.
Fault fault_at(const Origin& origin, std::string_view value, std::string_view problem);

/// `file:line: text`, without the parts that are missing.
std::string to_string(const Fault& fault);

/// The case, the mesh or the command line is wrong (exit code 2). Faults are sorted by file and line;
/// `what()` has one line for each.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Fault> faults);
  explicit InputError(Fault fault);
  /// A fault that has no file.
  explicit InputError(std::string text);
  const std::vector<Fault>& faults() const { return faults_; }

 private:
  std::vector<Fault> faults_;
};

/// A file could not be read or written (exit code 3).
class FileError : public std::runtime_error {
 public:
  /// `path: problem`
  FileError(std::string_view path, std::string_view problem);
};

}  // namespace etendue
