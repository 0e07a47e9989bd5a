// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "mesh/tetrahedra/tetrahedral_mesh.h"
#include "solver/problem/lights/light.h"

namespace etendue {

/// The parts of a triangle that a beam with a profile lights, as triangles on which a rule of degree 5
/// integrates the profile to about 1e-6.
std::vector<std::array<Vec3, 3>> beam_pieces(const BeamProfile& profile, const std::array<Vec3, 3>& triangle);

/// Power by which a beam enters by a boundary face, over its irradiance on the axis [length^2]: the integral
/// of the profile over the cross-section of the face; 0 where the beam leaves by the face.
double entering_area(const BeamLight& beam, const TetrahedralMesh& mesh, FaceIndex face);

/// Integral of the profile over a triangle, divided by its area.
double mean_profile(const BeamProfile& profile, const std::array<Vec3, 3>& triangle);

}  // namespace etendue
