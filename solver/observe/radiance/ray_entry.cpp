// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/radiance/ray_entry.h"

namespace etendue {

std::optional<PointInCell> RayEntry::enter(const Vec3& origin, const Vec3& direction) const {
  const std::vector<CellPoint> cells = locator_.find(origin);
  if (!cells.empty()) return PointInCell{cells.front().cell, origin};
  const std::optional<BoundaryEntry> entry = boundary_.first_entry(origin, direction);
  if (!entry) return std::nullopt;
  return PointInCell{mesh_.owner(entry->face), entry->point};
}

}  // namespace etendue
