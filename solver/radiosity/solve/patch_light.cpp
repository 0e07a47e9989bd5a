// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/solve/patch_light.h"

#include <algorithm>
#include <numbers>

#include "solver/radiosity/solve/sheet_passages.h"

namespace etendue {
namespace {

/// [patch][band] of what lies behind sheets; empty where nothing lets light through.
std::vector<double> irradiance_behind(const Problem& problem, const WallPatches& patches,
                                      const std::vector<double>& irradiance) {
  if (std::ranges::none_of(problem.walls(), [](const Wall& wall) { return wall.transmits(); })) return {};
  const auto bands = static_cast<std::size_t>(problem.band_count());
  std::vector<double> behind(irradiance.size(), 0);
  for (const SheetPassage& passage : sheet_passages(problem.mesh(), patches))
    for (std::size_t b = 0; b < bands; ++b)
      behind[passage.to * bands + b] += passage.share * irradiance[passage.from * bands + b];
  return behind;
}

}  // namespace

PatchLight light_on_patches(const Problem& problem, const WallPatches& patches, const RadiosityState& state) {
  const auto bands = static_cast<std::size_t>(problem.band_count());
  const std::vector<double> behind = irradiance_behind(problem, patches, state.irradiance);
  PatchLight light;
  for (std::size_t p = 0; p < patches.patches.size(); ++p) {
    const Wall& wall = problem.wall(patches.walls[p]);
    for (const TriangleCorners& triangle : patches.patches[p].triangles()) {
      light.triangles.push_back(triangle);
      light.walls.push_back(patches.walls[p]);
      light.patches.push_back(static_cast<std::int32_t>(p));
      for (std::size_t b = 0; b < bands; ++b) {
        const double incident = state.irradiance[p * bands + b];
        light.irradiance.push_back(incident);
        const double through = behind.empty() ? 0 : wall.transmitted(b) * behind[p * bands + b];
        const double redirected = state.redirected.empty() ? 0 : state.redirected[p * bands + b];
        light.exitance.push_back(std::numbers::pi * wall.radiance[b] + wall.diffuse[b] * incident + through +
                                 redirected);
      }
    }
  }
  return light;
}

bool are_finer_than_faces(const WallPatches& patches) {
  return std::ranges::any_of(patches.of_faces,
                             [](const std::vector<FacePart>& parts) { return parts.size() > 1; });
}

}  // namespace etendue
