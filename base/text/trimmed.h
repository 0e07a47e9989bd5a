// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string_view>

namespace etendue {

/// What separates words in a text file.
inline constexpr std::string_view blanks = " \t\r\n\f\v";

/// The text without blanks at its ends.
inline std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

}  // namespace etendue
