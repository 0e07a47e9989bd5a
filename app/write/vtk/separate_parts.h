// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <array>
#include <vector>

#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue {

/// The cells of a mesh with four points of their own each, so that jumps between them are seen: point 4 c + i
/// is vertex i of cell c.
vtkSmartPointer<vtkUnstructuredGrid> separate_cells(const TetrahedralMesh& mesh);

/// Triangles that share no points. `corners` are the numbers of the three within each [triangle].
vtkSmartPointer<vtkPolyData> separate_triangles(const std::vector<double>& coordinates,
                                                const std::vector<std::array<vtkIdType, 3>>& corners);

/// The boundary faces of a mesh with three points of their own each, counterclockwise as seen from outside
/// the domain: point 3 f + i is vertex i of face f.
vtkSmartPointer<vtkPolyData> separate_faces(const TetrahedralMesh& mesh);

}  // namespace etendue
