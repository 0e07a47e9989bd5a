// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/temperatures.h"

#include <algorithm>

namespace etendue {
namespace {

template <class Entry>
bool any_temperature(const std::map<std::string, Entry>& entries) {
  return std::ranges::any_of(entries, [](const auto& entry) { return entry.second.temperature.has_value(); });
}

}  // namespace

bool has_temperatures(const Case& input) {
  return any_temperature(input.media) || any_temperature(input.walls);
}

}  // namespace etendue
