// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/geometry/arrangement/plane_sections.h"

#include <array>

namespace etendue {

Contact contact_of(const ExactPlane& plane, std::span<const ExactPoint> corners) {
  std::array<int, 3> count{};  // below the plane, on it, above it
  for (const ExactPoint& corner : corners) ++count[static_cast<std::size_t>(1 + plane.oriented_side(corner))];
  if (count[0] > 0 && count[2] > 0) return Contact::kCut;
  if (count[0] == 0 && count[2] == 0) return Contact::kFace;
  return count[1] > 1 ? Contact::kTouch : Contact::kNone;
}

std::vector<ExactPoint> section_of(const ExactPlane& plane, std::span<const ExactPoint> ring) {
  std::vector<ExactPoint> points;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const ExactPoint &p = ring[i], &q = ring[(i + 1) % ring.size()];
    const CGAL::Oriented_side p_side = plane.oriented_side(p), q_side = plane.oriented_side(q);
    if (p_side == CGAL::ON_ORIENTED_BOUNDARY) {
      points.push_back(p);
    } else if (p_side != q_side && q_side != CGAL::ON_ORIENTED_BOUNDARY) {
      const auto crossing = CGAL::intersection(plane, Exact::Segment_3(p, q));
      points.push_back(boost::get<ExactPoint>(*crossing));
    }
  }
  return points;
}

}  // namespace etendue
