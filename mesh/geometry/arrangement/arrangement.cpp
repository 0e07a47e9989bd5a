// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/geometry/arrangement/arrangement.h"

#include <fmt/format.h>

#include <algorithm>

#include "mesh/geometry/arrangement/body_arrangement.h"
#include "mesh/geometry/arrangement/box_arrangement.h"
#include "mesh/geometry/arrangement/snapping.h"
#include "mesh/geometry/primitives/primitive_checks.h"

namespace etendue {
namespace {

/// Regions that later primitives have overwritten whole have no seed: their names go.
void drop_empty_regions(SurfaceComplex& surface, const Log& log) {
  std::vector<std::string> kept;
  std::vector<int> number(surface.region_names.size(), -1);
  for (std::size_t i = 0; i < surface.region_names.size(); ++i) {
    const bool seeded = std::any_of(surface.seeds.begin(), surface.seeds.end(), [&](const RegionSeed& seed) {
      return seed.region == static_cast<int>(i);
    });
    if (seeded) {
      number[i] = static_cast<int>(kept.size());
      kept.push_back(surface.region_names[i]);
    } else if (log) {
      log(fmt::format("region \"{}\" is overwritten whole by later primitives", surface.region_names[i]));
    }
  }
  for (RegionSeed& seed : surface.seeds) seed.region = number[static_cast<std::size_t>(seed.region)];
  surface.region_names = std::move(kept);
}

}  // namespace

SurfaceComplex arrange(const Geometry& scene, const Log& log) {
  check_primitives(scene);
  const Geometry geometry = snapped(scene, log);
  const bool only_boxes =
      std::all_of(geometry.primitives.begin(), geometry.primitives.end(),
                  [](const Primitive& primitive) { return std::holds_alternative<BoxPrimitive>(primitive); });
  SurfaceComplex surface =
      only_boxes && geometry.sheets.empty() ? arrange_boxes(geometry) : arrange_bodies(geometry);
  if (surface.seeds.empty())
    throw InputError(fault_at(base_of(geometry.primitives.back()).origin, "",
                              "the holes leave no region (there is nothing to mesh)"));
  drop_empty_regions(surface, log);
  return surface;
}

}  // namespace etendue
