// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/geometry/primitives/surface_complex.h"
#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue {

/// The cube [0, side]^3, region "domain", walls "xmin" ... "zmax".
SurfaceComplex cube_surface(double side = 1);

/// The same with the box [side/4, 3 side/4]^3 in it as region "inner"; the rest is "domain".
SurfaceComplex two_region_surface(double side = 1);

/// The cube filled by TetGen at quality 1.4. A unit cube has about 11,700, 60,000 and 200,000 cells with
/// max_volume 2.25e-4, 3.4e-5 and 1e-5.
TetrahedralMesh cube_mesh(double max_volume, double side = 1);

/// The cube with the inner box, filled by TetGen; one bound for both regions.
TetrahedralMesh two_region_mesh(double max_volume, double side = 1);

/// The corner of the unit cube at the origin.
RawMesh single_tetrahedron_raw();
TetrahedralMesh single_tetrahedron();

/// The unit cube cut into six tetrahedra around its diagonal (Kuhn 1960), walls "xmin" ... "zmax".
RawMesh kuhn_cube_raw();

/// Six blocks of six cells around the z axis, twisted like the blades of a fan: light that travels along +z
/// goes through them in a circle, so no order of the cells puts each after its upwind cells.
TetrahedralMesh cyclic_ring();

}  // namespace etendue
