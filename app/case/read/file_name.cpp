// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/file_name.h"

#include <algorithm>

namespace etendue {
namespace {

/// Names of files have at most 255 bytes on Linux, endings such as .intensity.csv included.
constexpr std::size_t longest_name = 200;

bool is_control(char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; }

}  // namespace

std::string file_name(Section& section, std::string_view key) {
  const std::string name = section.text_if(key).value_or("");
  if (name.size() > longest_name)
    section.fault(key, "is too long to name a file; use at most 200 bytes");
  else if (name.starts_with('.') || name.find('/') != std::string::npos ||
           std::ranges::any_of(name, is_control))
    section.fault(key, "cannot name a file; use letters, digits, - and _");
  return name;
}

}  // namespace etendue
