// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/toml/toml_fault.h"

#include <fmt/format.h>

#include <algorithm>

namespace etendue {
namespace {

/// Bytes shown before and after the caret of a long line.
constexpr std::size_t shown_before = 60, shown_after = 40;
/// Bytes shown of a text that quotes a long value.
constexpr std::size_t longest_problem = 300;

/// The text with ? in place of control characters and of what is not UTF-8.
std::string printable(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const std::size_t valid = first_invalid_utf8(text);
    for (const char c : text.substr(0, valid))
      shown += (static_cast<unsigned char>(c) < 0x20 && c != '\t') || c == 0x7f ? '?' : c;
    if (valid < text.size()) shown += '?';
    text.remove_prefix(std::min(text.size(), valid + 1));
  }
  return shown;
}

/// The line, or a part of a long one, and a caret below.
std::string picture_of(const TomlPlace& place) {
  const std::string_view line = place.line;
  std::size_t begin = place.at > shown_before ? place.at - shown_before : 0;
  std::size_t end = std::min(line.size(), place.at + shown_after);
  while (begin > 0 && continues_character(line[begin])) --begin;
  while (end < line.size() && continues_character(line[end])) ++end;
  const std::string left = begin > 0 ? "..." : "", right = end < line.size() ? "..." : "";
  const std::string before = left + printable(line.substr(begin, place.at - begin));
  std::string indent;
  for (const char c : before)
    if (!continues_character(c)) indent += c == '\t' ? '\t' : ' ';
  return fmt::format("\n    {}{}{}\n    {}^", before, printable(line.substr(place.at, end - place.at)), right,
                     indent);
}

}  // namespace

std::string toml_message(const TomlProblem& problem, const std::string& file) {
  const TomlPlace& place = problem.place;
  std::string text = problem.text;
  if (text.size() > longest_problem) text = text.substr(0, longest_problem) + "...";
  const std::size_t column = 1 + characters_in(place.line.substr(0, place.at));
  return fmt::format("{}:{}:{}: {}{}", file, place.line_number, column, printable(text), picture_of(place));
}

}  // namespace etendue
