// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/run/report/field_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/case/build/field_uses.h"
#include "app/case/build/temperature_range.h"
#include "app/case/values/mixture_values.h"

namespace etendue {
namespace {

std::string unit_of(const std::string& key, const Units& units) {
  if (key == "albedo") return "";
  if (key == "emission") return fmt::format(" {}/({}^3 sr)", units.power, units.length);
  if (key == "power_density") return fmt::format(" {}/{}^3", units.power, units.length);
  if (key == "radiance") return fmt::format(" {}/({}^2 sr)", units.power, units.length);
  if (key == "temperature" || key == "initial_temperature") return " K";
  if (key == "molar_ratio") return "";
  if (key == "gas_pressure") return " atm";
  if (key == "heat_source") return " W/m^3";
  if (key == "conductivity") return " W/(m K)";
  if (key == "heat_capacity") return " J/(m^3 K)";
  return fmt::format(" 1/{}", units.length);
}

/// One range for all places that have the same temperature.
std::vector<TemperatureRange> joined_places(const std::vector<TemperatureRange>& ranges) {
  std::vector<TemperatureRange> joined;
  for (const TemperatureRange& range : ranges) {
    const auto same = std::ranges::find_if(joined, [&](const TemperatureRange& other) {
      return range.lowest == range.highest && other.lowest == range.lowest && other.highest == range.highest;
    });
    if (same == joined.end())
      joined.push_back(range);
    else
      same->place += ", " + range.place;
  }
  return joined;
}

/// Of the power of a blackbody; bands that hold less are likely in another unit, or of visible light alone.
constexpr double sufficient_fraction = 0.9;

std::string temperature_text(const TemperatureRange& range, const Bands& bands) {
  std::string text = fmt::format("temperature of {}: ", range.place);
  text += range.lowest == range.highest
              ? fmt::format("{:.6g} K", range.mean)
              : fmt::format("from {:.6g} to {:.6g}, mean {:.6g} K", range.lowest, range.highest, range.mean);
  if (range.mean > 0 && !bands.edges.empty())
    text += fmt::format("; the bands hold {:.3g} % of the power of a blackbody of {:.4g} K",
                        100 * range.fraction_in_bands, range.mean);
  if (range.mean > 0 && range.fraction_in_bands < sufficient_fraction)
    text += "; caution: the rest is emitted by nothing; use wider bands.edges [nm]";
  return text;
}

std::string mixture_text(const MolarRatioRange& range) {
  std::string text =
      fmt::format("molar ratio of the gases: from {:.6g} to {:.6g}", range.lowest, range.highest);
  if (range.beyond > 0)
    text +=
        fmt::format("; caution: beyond {:g} to {:g} in {:.3g} % of their volume, where the nearest is used",
                    lowest_molar_ratio, highest_molar_ratio, 100 * range.beyond);
  return text;
}

}  // namespace

std::vector<std::string> field_texts(const Case& input, const TetrahedralMesh& mesh) {
  std::vector<std::string> texts;
  for (const FieldUse& use : field_uses(input, mesh))
    texts.push_back(fmt::format("{} of {}: {}, from {:.6g} to {:.6g}, mean {:.6g}{}", use.key, use.place,
                                use.field, use.smallest, use.largest, use.mean,
                                unit_of(use.key, input.units)));
  if (const auto range = molar_ratio_range(input, mesh)) texts.push_back(mixture_text(*range));
  for (const TemperatureRange& range : joined_places(temperature_ranges(input, mesh)))
    texts.push_back(temperature_text(range, input.bands));
  return texts;
}

}  // namespace etendue
