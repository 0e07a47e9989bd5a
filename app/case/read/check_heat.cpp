// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/check_heat.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/case/read/materials/read_temperature.h"

namespace etendue {
namespace {

/// The first medium whose temperature follows by iteration; null: none.
const MediumCase* iterating_medium(const Case& input) {
  const auto found = std::ranges::find_if(
      input.media, [](const auto& entry) { return entry.second.iterates_temperature(); });
  return found == input.media.end() ? nullptr : &found->second;
}

/// Whether something takes heat away: a wall that absorbs, or holds a temperature.
bool has_heat_sink(const Case& input) {
  const auto takes_heat = [&](const WallCase& wall) {
    if (wall.temperature || wall.refractive_index != 1) return true;
    for (int band = 0; band < input.bands.count(); ++band)
      if (!wall.heat_flux && absorptivity(wall, band) > 0) return true;
    return false;
  };
  const auto keeps_temperature = [](const MediumCase& medium) { return medium.temperature.has_value(); };
  return std::ranges::any_of(input.walls, [&](const auto& entry) { return takes_heat(entry.second); }) ||
         std::ranges::any_of(input.media, [&](const auto& entry) { return keeps_temperature(entry.second); });
}

}  // namespace

void check_heat(const Case& input, std::vector<Fault>& faults) {
  const MediumCase* medium = iterating_medium(input);
  if (medium == nullptr) return;
  const auto refuse = [&](const char* what) {
    faults.push_back(fault_at(
        medium->origin, "",
        fmt::format("its temperature follows by iteration (conductivity, or several bands), {}", what)));
  };
  if (input.photons) refuse("not by photons (not in this version); use solve.method = \"auto\"");
  if (input.radiosity) refuse("not by radiosity (not in this version); use solve.method = \"auto\"");
  if (input.rotations > 1)
    refuse("not on several rotations of the directions (not in this version); use one");
  if (input.first_collided)
    refuse("not with directions.first_collided (not in this version); leave them out");
  if (input.initial)
    refuse("not from a solution (not in this version: it has no temperatures); leave solve.initial out");
  if (input.solve.positivity != Positivity::none)
    refuse("not with space.positivity (not in this version); leave it out");
  if (medium->uncollided == Uncollided::yes)
    refuse("and its emission with it: not as a light (not in this version); leave uncollided out");
  if (input.exact) refuse("not with [exact] (not in this version); leave it out");
  if (!has_heat_sink(input))
    refuse("and nothing takes its heat away; give a wall a temperature or emissivity");
}

}  // namespace etendue
