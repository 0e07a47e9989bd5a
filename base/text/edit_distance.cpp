// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/text/edit_distance.h"

#include <algorithm>
#include <cctype>
#include <vector>

namespace etendue {
namespace {

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

// Longer words may be misspelt in more places; short ones resemble each other by accident.
int farthest_edit(std::string_view word) { return std::max<int>(1, static_cast<int>(word.size()) / 3); }

}  // namespace

int edit_distance(std::string_view first, std::string_view second) {
  const std::string a = lower(first), b = lower(second);
  const std::size_t columns = b.size() + 1;
  std::vector<int> distances((a.size() + 1) * columns);  // [prefix of a][prefix of b]
  const auto at = [&](std::size_t i, std::size_t j) -> int& { return distances[i * columns + j]; };
  for (std::size_t i = 0; i <= a.size(); ++i) at(i, 0) = static_cast<int>(i);
  for (std::size_t j = 0; j <= b.size(); ++j) at(0, j) = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i)
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int substitution = at(i - 1, j - 1) + (a[i - 1] == b[j - 1] ? 0 : 1);
      at(i, j) = std::min({at(i - 1, j) + 1, at(i, j - 1) + 1, substitution});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        at(i, j) = std::min(at(i, j), at(i - 2, j - 2) + 1);
    }
  return at(a.size(), b.size());
}

std::string closest_name(std::string_view misspelt, std::span<const std::string> names) {
  std::string closest;
  int smallest = farthest_edit(misspelt) + 1;
  for (const std::string& name : names) {
    const int distance = edit_distance(misspelt, name);
    // A word whose every letter would change is not meant.
    if (distance >= smallest || distance >= static_cast<int>(name.size())) continue;
    smallest = distance;
    closest = name;
  }
  return closest;
}

std::string suggestion(std::string_view misspelt, std::span<const std::string> names) {
  const std::string name = closest_name(misspelt, names);
  return name.empty() ? "" : "; did you mean \"" + name + "\"?";
}

std::string enumerate(std::span<const std::string> names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? " or " : ", ";
    text += names[i];
  }
  return text;
}

}  // namespace etendue
