// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace etendue {

/// Place in a TOML text where it breaks the grammar, with its line and the open brackets.
struct TomlPlace {
  std::string_view text;               ///< all of it
  int line_number = 1;                 ///< from 1
  std::string_view line;               ///< without its end
  std::size_t at = 0;                  ///< byte in the line; the length of the line where that ends too soon
  std::vector<std::size_t> open = {};  ///< bytes in the text of [ and { that are not closed before the place
  std::optional<std::size_t> quote = {};  ///< byte in the text of the quote that opened a text, if inside one
  std::size_t value = 0;  ///< byte in the line where the value, key or table that holds the place begins

  /// Whether the line ends here.
  bool at_end() const { return at >= line.size(); }
  std::string_view rest() const { return line.substr(std::min(at, line.size())); }
  /// The character here by its UTF-8 bytes; empty at the end.
  std::string_view character() const;
  /// Value that holds the place, up to a comment, to the end of the line, or in a list to the next comma.
  std::string_view value_text() const;
  /// Same place moved to a byte of the text.
  TomlPlace moved_to(std::size_t byte) const;
};

/// The place in line `line` (from 1) at character `column` (from 1) of valid UTF-8.
TomlPlace toml_place(std::string_view text, int line, int column);

/// Whether the byte continues a character of UTF-8.
inline bool continues_character(char byte) { return (static_cast<unsigned char>(byte) & 0xc0) == 0x80; }

/// Number of characters in valid UTF-8.
std::size_t characters_in(std::string_view text);

/// Byte of the first sequence that is not UTF-8; the length of the text where all is.
std::size_t first_invalid_utf8(std::string_view text);

}  // namespace etendue
