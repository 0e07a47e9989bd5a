// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/angular/sets/direction_set.h"
#include "solver/problem/problem.h"

namespace etendue {

/// A phase function whose forward peak is narrow beside the distance of the directions.
struct NarrowPhase {
  std::string region;
  double half_width;  ///< angle at which the phase function has fallen to half of its value forward [rad]
};

/// How finely cells and directions resolve a problem, known before it is solved.
struct Resolution {
  /// Extinction times edge of the cells that are not void, each in its thickest band: median and largest; 0
  /// without such cells.
  double median_thickness = 0, largest_thickness = 0;
  /// Median of (extinction - g scattering) times edge, in transport mean free paths, of the cells at lights:
  /// those that hold a lamp or a corner of one, or have a face on a wall that shines or lets a beam in. 0
  /// without such cells.
  double transport_thickness_at_lights = 0;
  /// Pairs of a cell and a band whose mass is lumped where that is left to the program: those thicker than
  /// lumping_thickness, forward scattering omitted; and all pairs.
  long thick_count = 0, pair_count = 0;
  double direction_spacing = 0;          ///< side of a square as large as the mean weight [rad]
  std::optional<NarrowPhase> narrowest;  ///< of the phase functions in use; none if all are wide
};

/// `cells` locates the points of the mesh of the problem.
Resolution resolution_of(const Problem& problem, const DirectionSet& directions, const CellLocator& cells);

}  // namespace etendue
