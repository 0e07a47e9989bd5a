// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <variant>
#include <vector>

#include "base/vec3.h"
#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/problem/problem.h"
#include "solver/uncollided/lights/light_setup.h"

namespace etendue {

/// The fluence at a point [power/length^2].
struct PointFluence {
  std::vector<CellPoint> cells;  ///< where the point lies, from CellLocator::find; values are volume-weighted
};

/// The mean irradiance at points, on the side that a normal points to [power/length^2].
struct MeanIrradiance {
  std::vector<std::vector<CellPoint>> points;  ///< at least one, each as of a fluence
  Vec3 normal = Vec3::UnitZ();                 ///< unit
};

/// The power that arrives at a wall [power].
struct ArrivingPower {
  int wall = 0;
};

/// The power that the medium of a region absorbs [power].
struct AbsorbedPower {
  int region = 0;
};

/// A quantity <r, u> that is linear in the radiance, in each band alone.
using Response = std::variant<PointFluence, MeanIrradiance, ArrivingPower, AbsorbedPower>;

/// The point where cells of CellLocator::find have it, in the first of them.
PointInCell point_of(const TetrahedralMesh& mesh, const std::vector<CellPoint>& cells);

/// Power per volume that a cell absorbs by the mean fluence in it [1/length], 0 outside of the region.
double absorbed_share(const Problem& problem, const AbsorbedPower& response, CellIndex cell, int band);

/// Uncollided light's own part of a response, [band]: at points as LightSetup::at() has it, at walls and in
/// regions that of the field of these lights.
std::vector<double> uncollided_response(const Response& response, const LightSetup& lights,
                                        const UncollidedField& field);

}  // namespace etendue
