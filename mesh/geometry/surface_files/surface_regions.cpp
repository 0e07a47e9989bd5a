// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/geometry/surface_files/surface_regions.h"

#include <fmt/format.h>

namespace etendue {

FilledParts fill_parts(const std::vector<Vec3>& points, const std::vector<SidedFacet>& facets,
                       const SurfaceFileOptions& options, std::vector<std::string>& region_names) {
  FilledParts filled;
  filled.parts = enclosed_parts(points, facets);
  filled.depth = depths(filled.parts, points, facets);
  filled.region.assign(filled.parts.size(), -1);
  std::vector<Fault> faults;
  for (const auto& [name, point] : options.regions) {
    const int part = part_at(point, filled.parts, filled.depth, points, facets);
    const auto report = [&, &name = name, &point = point](const std::string& problem) {
      faults.push_back(fault_at(
          options.origin, "",
          fmt::format("regions.{} = [{}, {}, {}]: {}", name, point.x(), point.y(), point.z(), problem)));
    };
    if (part < 0) {
      report("lies in no closed part of the surface; give a point inside");
    } else if (int& region = filled.region[static_cast<std::size_t>(part)]; region >= 0) {
      report(fmt::format("lies in the same part as region \"{}\"; parts are told apart by closed surfaces",
                         region_names[static_cast<std::size_t>(region)]));
    } else {
      region = static_cast<int>(region_names.size());
      region_names.push_back(name);
    }
  }
  if (!faults.empty()) throw InputError(std::move(faults));
  return filled;
}

void add_part_points(const FilledParts& filled, SurfaceComplex& surface) {
  for (std::size_t i = 0; i < filled.parts.size(); ++i) {
    if (filled.region[i] < 0)
      surface.holes.push_back(filled.parts[i].point);
    else
      surface.seeds.push_back({filled.parts[i].point, filled.region[i]});
  }
}

}  // namespace etendue
