// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <vtkType.h>

#include "mesh/polyhedra/polyhedral_mesh.h"

class vtkUnstructuredGrid;

namespace etendue {

class VtuNames;

std::vector<Vec3> points_of(vtkUnstructuredGrid& grid);

/// The points of a cell; `wanted` of them, or any number where that is 0. Throws InputError.
std::vector<int> points_of_cell(const std::string& file, vtkUnstructuredGrid& grid, vtkIdType cell,
                                std::size_t wanted);

/// Returns whether cells are there that have a volume and are no tetrahedra. Throws InputError where one has
/// curved edges.
bool has_other_volumes(const std::string& file, vtkUnstructuredGrid& grid);

/// The numbers of the cells that have a volume.
std::vector<vtkIdType> volume_cells(vtkUnstructuredGrid& grid);

/// The cells that have a volume, and the triangles and polygons of walls; without names one region and no
/// walls. Throws InputError.
PolyhedralMesh polyhedra_of_vtu(const std::string& file, vtkUnstructuredGrid& grid, VtuNames* names);

}  // namespace etendue
