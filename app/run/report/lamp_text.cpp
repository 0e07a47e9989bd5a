// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/run/report/lamp_text.h"

#include <fmt/format.h>

#include "app/write/result/beam_power.h"
#include "app/write/result/lamp_light.h"

namespace etendue {
namespace {

/// Of the power of a beam, that of the rule by which it is integrated.
constexpr double rounding = 1e-5;
constexpr std::size_t lamps_told = 8;

std::string beam_text(const BeamPower& beam, const std::string& unit) {
  std::string text =
      fmt::format("beam {}: {:.4g} of {:.4g} {} comes in", beam.name, beam.entering, beam.power, unit);
  if (beam.turned_back > rounding * beam.power)
    text += fmt::format(", {:.4g} is reflected or absorbed by its walls from outside", beam.turned_back);
  if (beam.behind_symmetry > rounding * beam.power)
    text += fmt::format(", {:.4g} is that behind the symmetry planes", beam.behind_symmetry);
  if (beam.beside > much_beside * beam.power)
    text += fmt::format(
        "\ncaution: beam {}: {:.3g} % of its power passes beside its walls and is left out of the "
        "balance; move it, make it narrower, or name all walls that it meets",
        beam.name, 100 * beam.beside / beam.power);
  return text + "\n";
}

}  // namespace

std::string lamp_text(const Problem& problem, const Case& input) {
  std::string text;
  const std::vector<LampLight> lamps = lamp_lights(problem, input);
  for (std::size_t i = 0; i < lamps.size() && i < lamps_told; ++i)
    text += fmt::format("lamp {}: {:.4g} {} in the bands, {:.5g} lm, {:.4g} lm/W{}{}\n", lamps[i].name,
                        lamps[i].power, input.units.power, lamps[i].luminous_flux, lamps[i].efficacy,
                        lamps[i].note.empty() ? "" : "; ", lamps[i].note);
  if (lamps.size() > lamps_told) text += fmt::format("and {} more lamps\n", lamps.size() - lamps_told);
  for (const BeamPower& beam : beam_powers(problem, input)) text += beam_text(beam, input.units.power);
  for (const WallBeam& beam : wall_beams(problem, input))
    text += fmt::format("beam {}: {:.4g} {} on its wall, {:.4g} {}/{}^2 across it\n", beam.name, beam.power,
                        input.units.power, beam.irradiance, input.units.power, input.units.length);
  for (const Daylight& day : daylight(input))
    text += fmt::format("{}: {:.4g} {}/{}^2{} on a level plane{}{}\n", day.name, day.irradiance,
                        input.units.power, input.units.length,
                        day.illuminance < 0 ? "" : fmt::format(", {:.5g} lx", day.illuminance),
                        day.note.empty() ? "" : "; ", day.note);
  return text;
}

}  // namespace etendue
