// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/build/build.h"

namespace etendue {

DirectionSet build_directions(const Case& input) {
  std::optional<ConeRefinement> cone = input.direction_refinement;
  if (cone && input.direction_rotation)
    cone->direction = input.direction_rotation->transpose() * cone->direction;
  const DirectionSet set = cone ? directions_ldfe_sq(input.direction_order, *cone)
                                : make_directions(input.direction_set, input.direction_order);
  return input.direction_rotation ? rotated(set, *input.direction_rotation) : set;
}

}  // namespace etendue
