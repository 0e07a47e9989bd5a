// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/vtk/separate_parts.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include <Eigen/Geometry>
#include <cstdint>

#include "app/write/vtk/vtk_arrays.h"

namespace etendue {
namespace {

vtkSmartPointer<vtkPoints> points_of_cells(const TetrahedralMesh& mesh) {
  std::vector<double> coordinates;
  coordinates.reserve(12 * static_cast<std::size_t>(mesh.cell_count()));
  for (const auto& vertices : mesh.cell_vertices())
    for (const std::int32_t v : vertices) {
      const Vec3& point = mesh.point(VertexIndex(v));
      coordinates.insert(coordinates.end(), point.begin(), point.end());
    }
  vtkNew<vtkPoints> points;
  points->SetData(vtk_array({"points", {}, {}}, 3, coordinates));
  return points.Get();
}

/// Counterclockwise as seen from outside the domain.
std::array<vtkIdType, 3> outward_order(const TetrahedralMesh& mesh, FaceIndex face) {
  const auto& v = mesh.vertices(face);
  const Vec3& origin = mesh.point(VertexIndex(v[0]));
  const Vec3 a = mesh.point(VertexIndex(v[1])) - origin;
  const Vec3 b = mesh.point(VertexIndex(v[2])) - origin;
  if (a.cross(b).dot(mesh.area_normal(face)) > 0) return {0, 1, 2};
  return {0, 2, 1};
}

}  // namespace

vtkSmartPointer<vtkUnstructuredGrid> separate_cells(const TetrahedralMesh& mesh) {
  vtkNew<vtkCellArray> cells;
  cells->AllocateExact(mesh.cell_count(), 4 * static_cast<vtkIdType>(mesh.cell_count()));
  for (int c = 0; c < mesh.cell_count(); ++c) {
    std::array<vtkIdType, 4> corners = positive_order(mesh, CellIndex(c));
    for (vtkIdType& corner : corners) corner += 4 * static_cast<vtkIdType>(c);
    cells->InsertNextCell(4, corners.data());
  }
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(points_of_cells(mesh));
  grid->SetCells(VTK_TETRA, cells);
  return grid.Get();
}

vtkSmartPointer<vtkPolyData> separate_triangles(const std::vector<double>& coordinates,
                                                const std::vector<std::array<vtkIdType, 3>>& corners) {
  const auto count = static_cast<vtkIdType>(corners.size());
  vtkNew<vtkCellArray> triangles;
  triangles->AllocateExact(count, 3 * count);
  for (vtkIdType t = 0; t < count; ++t) {
    std::array<vtkIdType, 3> points = corners[static_cast<std::size_t>(t)];
    for (vtkIdType& point : points) point += 3 * t;
    triangles->InsertNextCell(3, points.data());
  }
  vtkNew<vtkPoints> points;
  points->SetData(vtk_array({"points", {}, {}}, 3, coordinates));
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  return surface.Get();
}

vtkSmartPointer<vtkPolyData> separate_faces(const TetrahedralMesh& mesh) {
  std::vector<double> coordinates;
  std::vector<std::array<vtkIdType, 3>> corners;
  for (int f = 0; f < mesh.boundary_face_count(); ++f) {
    for (const std::int32_t v : mesh.vertices(FaceIndex(f))) {
      const Vec3& point = mesh.point(VertexIndex(v));
      coordinates.insert(coordinates.end(), point.begin(), point.end());
    }
    corners.push_back(outward_order(mesh, FaceIndex(f)));
  }
  return separate_triangles(coordinates, corners);
}

}  // namespace etendue
