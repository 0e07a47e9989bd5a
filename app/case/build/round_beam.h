// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "app/case/case.h"
#include "mesh/tetrahedra/search/cell_locator.h"
#include "mesh/tetrahedra/tetrahedral_mesh.h"
#include "solver/problem/lights/light.h"

namespace etendue {

/// Gives a beam the cross-section and the irradiance on the axis of a light of kind "beam".
void shape_beam(const LightCase& light, BeamLight& beam);

/// Follows the cross-section of a beam through a flat wall that refracts, to the beam inside: rays that meet
/// on the wall have the same coordinates. `normal` is that of the wall, `on_wall` a point of it.
void refract_profile(const Vec3& direction_outside, const Vec3& normal, const Vec3& on_wall,
                     BeamLight& inside);

/// The part of a light of kind "beam" that reaches its walls, before they reflect any of it: of all beams in
/// which the light comes in. More than 1 where it passes through them more than once.
double part_on_walls(const LightCase& light, std::span<const Light> beams, const TetrahedralMesh& mesh);

/// Faults where a light of kind "beam" misses all of its walls or passes through them more than once, and
/// where its position lies inside the domain.
void require_hit(const LightCase& light, const std::vector<Light>& beams, const CellLocator& locator,
                 const TetrahedralMesh& mesh, std::vector<Fault>& faults);

}  // namespace etendue
