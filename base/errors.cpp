// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/errors.h"

#include <algorithm>

namespace etendue {
namespace {

std::vector<Fault> sorted(std::vector<Fault> faults) {
  std::stable_sort(faults.begin(), faults.end(), [](const Fault& a, const Fault& b) {
    return a.file != b.file ? a.file < b.file : a.line < b.line;
  });
  return faults;
}

std::string lines_of(const std::vector<Fault>& faults) {
  std::string text;
  for (const Fault& fault : faults) {
    if (!text.empty()) text += '\n';
    text += to_string(fault);
  }
  return text;
}

}  // namespace

Fault fault_at(const Origin& origin, std::string_view value, std::string_view problem) {
  std::string text = origin.key;
  if (!value.empty()) {
    text += " = ";
    text += value;
  }
  if (!text.empty()) text += ": ";
  text += problem;
  return {origin.file, origin.line, text};
}

std::string to_string(const Fault& fault) {
  std::string text = fault.file;
  if (fault.line > 0) text += ":" + std::to_string(fault.line);
  if (!text.empty()) text += ": ";
  return text + fault.text;
}

InputError::InputError(std::vector<Fault> faults)
    : std::runtime_error(lines_of(sorted(faults))), faults_(sorted(std::move(faults))) {}

InputError::InputError(Fault fault) : InputError(std::vector<Fault>{std::move(fault)}) {}

InputError::InputError(std::string text) : InputError(Fault{"", 0, std::move(text)}) {}

FileError::FileError(std::string_view path, std::string_view problem)
    : std::runtime_error(std::string(path) + ": " + std::string(problem)) {}

}  // namespace etendue
