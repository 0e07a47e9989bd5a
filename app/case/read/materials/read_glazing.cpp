// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/materials/read_glazing.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/case/values/band_values.h"

namespace etendue {
namespace {

bool any_but_zero(const BandValues& values) {
  return std::ranges::any_of(values.values, [](const Value& value) {
    const double* number = std::get_if<double>(&value);
    return number == nullptr || *number != 0;
  });
}

}  // namespace

std::vector<Glazing> read_glazing(Section section, const Bands& bands) {
  const double index = section.number("refractive_index");
  const int panes = section.integer("panes");
  const std::optional<BandValues> values = read_band_values(section, "transmittance", bands);
  std::vector<Glazing> glazing;
  if (!values) {
    if (!section.has("transmittance"))
      section.fault("transmittance", "missing; use that at normal incidence");
    return glazing;
  }
  const double clear = Glazing::clear_transmittance(index, panes);
  for (int band = 0; band < bands.count(); ++band) {
    const double transmittance = std::get<double>(value_of(*values, band));
    if (transmittance > clear) {
      section.fault(
          "transmittance",
          fmt::format("exceeds {:.6g}, that of panes that absorb nothing ({} of refractive index {}); "
                      "use at most that",
                      clear, panes, index));
      return {};
    }
    glazing.emplace_back(transmittance, index, panes);
  }
  return glazing;
}

void check_glazed_wall(Section& section, const WallCase& wall) {
  const auto refuse = [&](bool is_there, const char* key) {
    if (is_there) section.fault(key, "beside glazing; remove one of them");
  };
  refuse(any_but_zero(wall.radiance), "radiance");
  refuse(wall.heat_flux.has_value(), "heat_flux");
  refuse(wall.convection.has_value(), "convection");
  refuse(any_but_zero(wall.specular), "specular");
  refuse(any_but_zero(wall.transmittance), "transmittance");
  refuse(!wall.glossy.empty(), "glossy");
  refuse(wall.refractive_index != 1, "refractive_index");
}

}  // namespace etendue
