// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/volume_bounds.h"

#include <numbers>

namespace etendue {
namespace {

// Of the regular tetrahedron with this edge.
double regular_volume(double edge) { return edge * edge * edge / (6 * std::numbers::sqrt2); }

// The bound for a region: its own, else that of "*", else 0.
double bound_of(const SizeBound& bound, const std::string& region) {
  for (const std::string& name : {region, std::string("*")})
    if (const auto found = bound.by_region.find(name); found != bound.by_region.end()) return found->second;
  return 0;
}

}  // namespace

std::vector<double> volume_bounds(const MeshCase& mesh, const std::vector<std::string>& regions) {
  std::vector<double> bounds;
  for (const std::string& region : regions) {
    if (mesh.max_volume)
      bounds.push_back(bound_of(*mesh.max_volume, region));
    else
      bounds.push_back(mesh.edge_length ? regular_volume(bound_of(*mesh.edge_length, region)) : 0);
  }
  return bounds;
}

}  // namespace etendue
