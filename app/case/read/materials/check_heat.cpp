// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/materials/check_heat.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/case/read/materials/read_temperature.h"
#include "app/case/values/medium_coefficients.h"
#include "app/case/values/value_algebra.h"

namespace etendue {
namespace {

/// Of the first medium or wall whose temperature follows by iteration; none: there is none.
std::optional<Origin> iterating_place(const Case& input) {
  for (const auto& [name, medium] : input.media)
    if (medium.iterates_temperature()) return medium.origin;
  for (const auto& [name, wall] : input.walls)
    if (wall.iterates_temperature()) return wall.origin;
  return std::nullopt;
}

/// Whether what a medium or wall emits is to be a light though its temperature follows by iteration.
bool shines_by_iteration(const Case& input) {
  const auto shines = [](const auto& entry) {
    return entry.second.iterates_temperature() && entry.second.uncollided == Uncollided::yes;
  };
  return std::ranges::any_of(input.media, shines) || std::ranges::any_of(input.walls, [&](const auto& entry) {
           return shines(entry) && !entry.second.beam;
         });
}

/// Whether something takes heat away: a wall that absorbs, or holds a temperature.
bool has_heat_sink(const Case& input) {
  const auto takes_heat = [&](const WallCase& wall) {
    if (wall.temperature || wall.refractive_index != 1) return true;
    if (wall.heat_flux || wall.convection)
      return wall.convection && wall.convection->heat_transfer_coefficient > 0;
    for (int band = 0; band < input.bands.count(); ++band)
      if (absorptivity(wall, band) > 0) return true;
    return false;
  };
  const auto absorbs = [&](const MediumCase& medium) {
    for (int band = 0; band < input.bands.count(); ++band) {
      const Value absorption = matter_values(medium, band).absorption;
      if (!is_number(absorption) || std::get<double>(absorption) > 0) return true;
    }
    return false;
  };
  const auto keeps_temperature = [&](const MediumCase& medium) {
    return medium.temperature && absorbs(medium);
  };
  return std::ranges::any_of(input.walls, [&](const auto& entry) { return takes_heat(entry.second); }) ||
         std::ranges::any_of(input.media, [&](const auto& entry) { return keeps_temperature(entry.second); });
}

}  // namespace

void check_heat(const Case& input, std::vector<Fault>& faults) {
  const std::optional<Origin> origin = iterating_place(input);
  if (!origin) return;
  const auto refuse = [&](const char* what) {
    faults.push_back(fault_at(*origin, "",
                              fmt::format("its temperature follows by iteration (conductivity, "
                                          "heat_capacity, convection, or several bands), {}",
                                          what)));
  };
  if (input.molar_ratio)
    faults.push_back(
        fault_at(input.molar_ratio->origin, "",
                 fmt::format("a formula or field, but the temperature of {} follows by iteration "
                             "(heat_source, conductivity or convection); use a number (not in "
                             "this version), or give temperature there",
                             origin->key)));
  if (input.photons) refuse("not by photons (not in this version); use solve.method = \"auto\"");
  if (input.radiosity) refuse("not by radiosity (not in this version); use solve.method = \"auto\"");
  if (input.rotations > 1)
    refuse("not on several rotations of the directions (not in this version); use one");
  if (input.first_collided)
    refuse("not with directions.first_collided (not in this version); leave them out");
  if (input.solve.positivity != Positivity::none)
    refuse("not with space.positivity (not in this version); leave it out");
  if (shines_by_iteration(input))
    refuse("and its emission with it: not as a light (not in this version); leave uncollided out");
  if (input.exact) refuse("not with [exact] (not in this version); leave it out");
  if (!input.time && !has_heat_sink(input))
    refuse("and nothing takes its heat away; give a wall a temperature, or convection with h above 0");
}

}  // namespace etendue
