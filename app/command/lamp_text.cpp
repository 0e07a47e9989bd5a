// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/command/lamp_text.h"

#include <fmt/format.h>

#include "app/write/lamp_light.h"

namespace etendue {
namespace {

constexpr std::size_t lamps_told = 8;

}  // namespace

std::string lamp_text(const Problem& problem, const Case& input) {
  std::string text;
  const std::vector<LampLight> lamps = lamp_lights(problem, input);
  for (std::size_t i = 0; i < lamps.size() && i < lamps_told; ++i)
    text += fmt::format("lamp {}: {:.4g} {} in the bands, {:.5g} lm, {:.4g} lm/W{}{}\n", lamps[i].name,
                        lamps[i].power, input.units.power, lamps[i].luminous_flux, lamps[i].efficacy,
                        lamps[i].note.empty() ? "" : "; ", lamps[i].note);
  if (lamps.size() > lamps_told) text += fmt::format("and {} more lamps\n", lamps.size() - lamps_told);
  for (const Daylight& day : daylight(input))
    text += fmt::format("{}: {:.4g} {}/{}^2{} on a level plane{}{}\n", day.name, day.irradiance,
                        input.units.power, input.units.length,
                        day.illuminance < 0 ? "" : fmt::format(", {:.5g} lx", day.illuminance),
                        day.note.empty() ? "" : "; ", day.note);
  return text;
}

}  // namespace etendue
