// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "base/vec3.h"
#include "mesh/geometry/primitives/sided_facet.h"

namespace etendue {

/// A side of a facet: `above` is where its normal points.
struct FacetSide {
  int facet;
  bool above;
};

/// A part of space that facets shut in, as seen from its outermost surface.
struct EnclosedPart {
  Vec3 point;                     ///< inside
  std::vector<FacetSide> around;  ///< the sides of its outermost surface
};

/// All of them. Facets must meet in whole edges only. Surfaces are told inside from outside by the solid
/// angle that they fill (van Oosterom & Strackee 1983, eq. 8).
std::vector<EnclosedPart> enclosed_parts(const std::vector<Vec3>& points,
                                         const std::vector<SidedFacet>& facets);

/// Whether the outermost surface of a part is around a point; other parts may lie in between.
bool encloses(const EnclosedPart& part, const Vec3& x, const std::vector<Vec3>& points,
              const std::vector<SidedFacet>& facets);

/// How many parts are around each, itself included.
std::vector<int> depths(const std::vector<EnclosedPart>& parts, const std::vector<Vec3>& points,
                        const std::vector<SidedFacet>& facets);

/// The number of the part that a point lies in: the deepest one around it; -1: none.
int part_at(const Vec3& x, const std::vector<EnclosedPart>& parts, const std::vector<int>& depths,
            const std::vector<Vec3>& points, const std::vector<SidedFacet>& facets);

}  // namespace etendue
