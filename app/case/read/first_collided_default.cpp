// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/first_collided_default.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/case/build/build.h"
#include "app/case/values/medium_coefficients.h"
#include "app/case/values/value_algebra.h"
#include "solver/materials/phase/half_width.h"

namespace etendue {
namespace {

/// 1,536 directions, 5 degrees apart; more of them bring little (docs/measurements/lights.md).
constexpr int fine_order = 4;

bool scatters_in_band(const MediumCase& medium, int band) {
  const Value scattering = matter_values(medium, band).scattering;
  return !is_number(scattering) || std::get<double>(scattering) > 0;
}

/// Of the phase functions that scatter [rad].
double smallest_half_width(const Case& input) {
  double smallest = std::numbers::pi;
  for (const auto& [name, medium] : input.media)
    for (int band = 0; band < input.bands.count() && !medium.phase.empty(); ++band)
      if (scatters_in_band(medium, band))
        smallest =
            std::min(smallest,
                     half_width(medium.phase[medium.phase.size() == 1 ? 0 : static_cast<std::size_t>(band)]));
  return smallest;
}

/// Whether all media scatter through moments, or leave it to the program.
bool may_scatter_by_moments(const MediumCase& medium) {
  const auto is_matrix = [](const ScatteringChoice& choice) {
    return choice.backend != ScatteringBackend::automatic && choice.backend != ScatteringBackend::moments;
  };
  return !medium.has_kernel && std::ranges::none_of(medium.choice, is_matrix) &&
         std::ranges::all_of(medium.directional, [](const auto& kind) { return kind.index() == 0; });
}

/// What light on a set of its own cannot be combined with, and sets whose directions were chosen one by one.
bool is_possible(const Case& input) {
  const auto iterates = [](const auto& entry) { return entry.second.iterates_temperature(); };
  return !input.photons && !input.radiosity && !input.exact && input.output.radiance_ordinates.empty() &&
         input.direction_set == "ldfe-sq" && !input.direction_refinement &&
         std::ranges::none_of(input.media, iterates) && std::ranges::none_of(input.walls, iterates) &&
         std::ranges::all_of(input.media,
                             [](const auto& entry) { return may_scatter_by_moments(entry.second); });
}

}  // namespace

void choose_first_collided(bool chosen, Case& input) {
  const auto is_followed_spot = [](const LightCase& light) {
    return light.kind == LightKind::spot && light.uncollided != Uncollided::no;
  };
  if (chosen || input.direction_order >= fine_order || !is_possible(input)) return;
  const auto spot = std::ranges::find_if(input.lights, is_followed_spot);
  if (spot == input.lights.end()) return;
  const double spacing = std::sqrt(4 * std::numbers::pi / build_directions(input).count());
  const double width = smallest_half_width(input);
  if (spacing <= width) return;
  constexpr double degrees = 180 / std::numbers::pi;
  input.first_collided = {
      "ldfe-sq", fine_order, input.directions_origin,
      fmt::format("{} shines into a medium that turns light by less than {:.2g} degrees (half "
                  "width), and the directions are {:.2g} degrees apart",
                  spot->name, width * degrees, spacing * degrees)};
}

}  // namespace etendue
