// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/materials/read_reduced_scattering.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/case/values/band_values.h"

namespace etendue {
namespace {

/// Below this 1 - g is rounding: of tables and series that scatter straight ahead alone.
constexpr double straight_ahead = 1e-9;

Value divided_value(const Value& value, double divisor) {
  if (const auto* number = std::get_if<double>(&value)) return *number / divisor;
  Formula formula = std::get<Formula>(value);
  formula.text = fmt::format("({})/{:.17g}", formula.text, divisor);
  return formula;
}

/// Whether the keys beside it allow the reduced coefficient.
bool check_others(Section& section) {
  for (const char* other : {"scattering", "extinction", "albedo"})
    if (section.has(other)) {
      section.fault(
          "reduced_scattering",
          fmt::format("is beside {}, which gives the scattering already; use one of the two", other));
      return false;
    }
  if (section.has("phase")) return true;
  section.fault("reduced_scattering",
                "without a phase function (scattering = reduced_scattering / (1 - g), g being its mean "
                "cosine); add phase, for example { model = \"henyey-greenstein\", g = 0.9 }");
  return false;
}

}  // namespace

std::optional<BandValues> read_reduced_scattering(Section& section, const Bands& bands, AngularSpace space,
                                                  const std::vector<PhaseFunction>& phases) {
  if (!section.has("reduced_scattering") || !check_others(section)) return std::nullopt;
  auto reduced = read_band_values(section, "reduced_scattering", bands);
  if (!reduced || phases.empty()) return std::nullopt;
  BandValues scattering{{}, reduced->origin};
  const std::size_t count = std::max(reduced->values.size(), phases.size());
  for (std::size_t band = 0; band < count; ++band) {
    const PhaseFunction& phase = phases[phases.size() == 1 ? 0 : band];
    const double g = phase_asymmetry(space == AngularSpace::plane ? in_plane(phase) : phase);
    if (1 - g < straight_ahead) {
      section.fault("reduced_scattering",
                    "with a phase function that scatters straight ahead alone (1 - g = 0, so no scattering "
                    "coefficient follows); use scattering");
      return std::nullopt;
    }
    scattering.values.push_back(divided_value(value_of(*reduced, static_cast<int>(band)), 1 - g));
  }
  return scattering;
}

}  // namespace etendue
