// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/text/number_columns.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "base/text/text_lines.h"
#include "base/text/trimmed.h"

namespace etendue {
namespace {

std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t comma = line.find(',');
    parts.push_back(trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos) return parts;
    line.remove_prefix(comma + 1);
  }
}

std::optional<double> finite_number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size() && std::isfinite(value);
  return whole ? std::optional(value) : std::nullopt;
}

bool is_header(const std::vector<std::string_view>& parts) {
  for (const std::string_view part : parts)
    if (finite_number(part)) return false;
  return true;
}

}  // namespace

std::vector<std::vector<double>> read_columns(const std::filesystem::path& path,
                                              const std::vector<std::string>& names) {
  std::vector<std::vector<double>> columns(names.size());
  TextLines lines(path, '#');
  for (bool first = true; lines.next(); first = false) {
    const std::vector<std::string_view> parts = split(lines.rest());
    if (first && is_header(parts)) continue;
    if (parts.size() != names.size())
      lines.fail(fmt::format("{} {} on this line; use {} ({}), between commas", parts.size(),
                             parts.size() == 1 ? "value" : "values", names.size(), fmt::join(names, ", ")));
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const auto value = finite_number(parts[i]);
      if (!value) lines.fail(names[i], parts[i], "is not a number; use a finite number with a decimal point");
      columns[i].push_back(*value);
    }
  }
  return columns;
}

}  // namespace etendue
