// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/progress/text_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace etendue {
namespace {

/// Significant digits of a number for people.
constexpr int most_digits = 6;

/// Characters on the screen: bytes of UTF-8 that do not continue one.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & '\xC0') != '\x80'; }));
}

std::string padded(const std::string& text, std::size_t width, Align align) {
  const std::string blank(width - width_of(text), ' ');
  return align == Align::left ? text + blank : blank + text;
}

}  // namespace

TextTable::TextTable(std::vector<std::string> names, std::vector<Align> alignment)
    : alignment_(std::move(alignment)), rows_{std::move(names)} {
  assert(alignment_.size() == rows_.front().size());
}

void TextTable::add_row(std::vector<std::string> row) {
  assert(row.size() == alignment_.size());
  rows_.push_back(std::move(row));
}

std::string TextTable::text() const {
  std::vector<std::size_t> widths(alignment_.size(), 0);
  for (const auto& row : rows_)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width_of(row[i]));
  std::string text;
  for (const auto& row : rows_) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) line += "  " + padded(row[i], widths[i], alignment_[i]);
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

std::string number(double value) { return fmt::format("{:.{}g}", value, most_digits); }

std::string number(double value, double error) {
  if (!(error > 0) || !std::isfinite(error) || value == 0) return number(value);
  const double places = std::floor(std::log10(std::abs(value))) - std::floor(std::log10(error)) + 2;
  // A value that is smaller than its error keeps one digit.
  const int digits = static_cast<int>(std::clamp(places, 1., static_cast<double>(most_digits)));
  std::string text = fmt::format("{:#.{}g}", value, digits);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

}  // namespace etendue
