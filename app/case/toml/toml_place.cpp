// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/toml/toml_place.h"

#include <algorithm>

#include "base/text/trimmed.h"

namespace etendue {
namespace {

/// Bytes of a UTF-8 sequence by its first; 0 where no sequence begins so.
std::size_t sequence_length(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xc2 && first <= 0xdf) return 2;
  if (first >= 0xe0 && first <= 0xef) return 3;
  if (first >= 0xf0 && first <= 0xf4) return 4;
  return 0;
}

std::size_t begin_of_line(std::string_view text, int line) {
  std::size_t begin = 0;
  for (; line > 1; --line) {
    const std::size_t end = text.find('\n', begin);
    if (end == std::string_view::npos) return text.size();
    begin = end + 1;
  }
  return begin;
}

std::string_view line_from(std::string_view text, std::size_t begin) {
  std::string_view line = text.substr(begin, text.find('\n', begin) - begin);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

/// Reads a text up to a place: brackets that are open there, and the quote, if any.
class Scan {
 public:
  Scan(std::string_view text, std::size_t end) : text_(text.substr(0, end)) {
    while (at_ < text_.size()) step();
  }
  std::vector<std::size_t> open;
  std::optional<std::size_t> quote;
  std::size_t value = 0;  ///< byte after the last = [ { or comma, or of the line

 private:
  void step() {
    const char c = text_[at_];
    if (c == '"' || c == '\'') return skip_string(c);
    if (c == '#') {
      at_ = std::min(text_.size(), text_.find('\n', at_));
      return;
    }
    ++at_;
    const bool top_level = open.empty();
    if (c == '[' || c == '{') open.push_back(at_ - 1);
    if ((c == ']' || c == '}') && !open.empty()) open.pop_back();
    if (c == '=' || c == '[' || c == '{' || (c == ',' && !top_level) || c == '\n') value = at_;
  }

  void skip_string(char mark) {
    const std::string three(3, mark);
    const bool is_long = text_.substr(at_).starts_with(three);
    const std::string end = is_long ? three : std::string(1, mark);
    const std::size_t begin = at_;
    for (at_ += end.size(); at_ < text_.size(); ++at_) {
      if (text_.substr(at_).starts_with(end)) {
        at_ += end.size();
        return;
      }
      if (mark == '"' && text_[at_] == '\\') ++at_;
    }
    at_ = text_.size();
    quote = begin;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

/// The place at a byte of the text.
TomlPlace place_at(std::string_view text, std::size_t byte) {
  byte = std::min(byte, text.size());
  const auto before = text.substr(0, byte);
  const std::size_t begin = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
  TomlPlace place{.text = text,
                  .line_number = 1 + static_cast<int>(std::ranges::count(before, '\n')),
                  .line = line_from(text, begin)};
  place.at = std::min(byte - begin, place.line.size());
  const Scan scan(text, byte);
  place.open = scan.open;
  place.quote = scan.quote;
  place.value = std::min(std::max(scan.value, begin) - begin, place.at);
  return place;
}

}  // namespace

std::string_view TomlPlace::character() const {
  if (at_end()) return "";
  return line.substr(at, std::max<std::size_t>(1, sequence_length(static_cast<unsigned char>(line[at]))));
}

std::string_view TomlPlace::value_text() const {
  const std::string_view from = line.substr(value);
  return trimmed(from.substr(0, from.find_first_of(open.empty() ? "#" : "#,]}")));
}

TomlPlace TomlPlace::moved_to(std::size_t byte) const { return place_at(text, byte); }

TomlPlace toml_place(std::string_view text, int line, int column) {
  const std::size_t begin = begin_of_line(text, line);
  const std::string_view whole = line_from(text, begin);
  std::size_t at = 0;
  for (int character = 1; character < column && at < whole.size(); ++character)
    at += std::max<std::size_t>(1, sequence_length(static_cast<unsigned char>(whole[at])));
  return place_at(text, begin + std::min(at, whole.size()));
}

std::size_t characters_in(std::string_view text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char byte) { return !continues_character(byte); }));
}

std::size_t first_invalid_utf8(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = sequence_length(static_cast<unsigned char>(text[at]));
    if (length == 0 || at + length > text.size()) return at;
    if (!std::ranges::all_of(text.substr(at + 1, length - 1), continues_character)) return at;
    at += length;
  }
  return text.size();
}

}  // namespace etendue
