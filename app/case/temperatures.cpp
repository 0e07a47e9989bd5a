// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/temperatures.h"

#include <algorithm>

namespace etendue {
namespace {

bool has_temperature(const MediumCase& medium) { return medium.temperature || medium.follows_from_heat(); }
bool has_temperature(const WallCase& wall) { return wall.temperature || wall.heat_flux || wall.convection; }

template <class Entry>
bool any_temperature(const std::map<std::string, Entry>& entries) {
  return std::ranges::any_of(entries, [](const auto& entry) { return has_temperature(entry.second); });
}

}  // namespace

bool has_temperatures(const Case& input) {
  return any_temperature(input.media) || any_temperature(input.walls);
}

bool steps_temperatures(const Case& input) { return input.time && has_temperatures(input); }

bool iterates_temperatures(const Case& input) {
  const auto iterates = [](const auto& entry) { return entry.second.iterates_temperature(); };
  return std::ranges::any_of(input.media, iterates) || std::ranges::any_of(input.walls, iterates);
}

}  // namespace etendue
