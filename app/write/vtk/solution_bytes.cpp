// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/vtk/solution_bytes.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "base/array_bytes.h"

namespace etendue {
namespace {

std::vector<std::string> take_lines(std::string_view& bytes) {
  const std::vector<char> text = take_array<char>(bytes);
  std::vector<std::string> lines;
  for (auto at = text.begin(); at != text.end();) {
    const auto end = std::find(at, text.end(), '\n');
    lines.emplace_back(at, end);
    at = end == text.end() ? end : end + 1;
  }
  return lines;
}

/// Whether errors, where they are known, are one for each cell and band.
bool fits(const SavedSolution& saved) {
  const std::size_t values = saved.result.direction_error.size();
  return values == 0 ||
         values == static_cast<std::size_t>(saved.cells) * static_cast<std::size_t>(saved.result.state.bands);
}

}  // namespace

std::optional<SavedSolution> take_solution(std::string_view bytes) {
  if (take_lines(bytes) != std::vector<std::string>{solution_format}) return std::nullopt;
  SavedSolution saved;
  for (const std::string& line : take_lines(bytes)) saved.mesh = line;
  for (const std::string& line : take_lines(bytes)) {
    const auto blank = line.rfind(' ');
    saved.case_parts.push_back({line.substr(0, blank), line.substr(blank + 1)});
  }
  saved.result.state.bands = static_cast<int>(take_lines(bytes).size());
  for (const std::int64_t count : take_array<std::int64_t>(bytes)) saved.cells = static_cast<int>(count);
  saved.result.state.fluence = take_array<double>(bytes);
  for (const StatePart& part : state_parts) saved.result.state.*part.values = take_array<double>(bytes);
  saved.result.direction_error = take_array<double>(bytes);
  saved.result.state.following = take_array<double>(bytes);
  return fits(saved) ? std::optional(std::move(saved)) : std::nullopt;
}

}  // namespace etendue
