// SPDX-License-Identifier: AGPL-3.0-or-later
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <Eigen/Geometry>
#include <array>

#include "app/write/color.h"
#include "app/write/unit_labels.h"
#include "app/write/vtk_arrays.h"
#include "app/write/vtk_files.h"

namespace etendue {
namespace {

vtkSmartPointer<vtkPoints> points_of_walls(const TetrahedralMesh& mesh) {
  std::vector<double> coordinates;
  coordinates.reserve(9 * static_cast<std::size_t>(mesh.boundary_face_count()));
  for (int f = 0; f < mesh.boundary_face_count(); ++f)
    for (const std::int32_t v : mesh.vertices(FaceIndex(f))) {
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

vtkSmartPointer<vtkPolyData> separate_triangles(const TetrahedralMesh& mesh) {
  vtkNew<vtkCellArray> triangles;
  triangles->AllocateExact(mesh.boundary_face_count(),
                           3 * static_cast<vtkIdType>(mesh.boundary_face_count()));
  for (int f = 0; f < mesh.boundary_face_count(); ++f) {
    std::array<vtkIdType, 3> corners = outward_order(mesh, FaceIndex(f));
    for (vtkIdType& corner : corners) corner += 3 * static_cast<vtkIdType>(f);
    triangles->InsertNextCell(3, corners.data());
  }
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(points_of_walls(mesh));
  surface->SetPolys(triangles);
  return surface.Get();
}

std::vector<double> differences(std::span<const double> a, std::span<const double> b) {
  std::vector<double> result(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) result[i] = a[i] - b[i];
  return result;
}

std::vector<double> wall_areas(const TetrahedralMesh& mesh) {
  std::vector<double> areas(static_cast<std::size_t>(mesh.boundary_face_count()));
  for (std::size_t f = 0; f < areas.size(); ++f) areas[f] = mesh.face_area_normals()[f].norm();
  return areas;
}

vtkSmartPointer<vtkPolyData> fields_of_walls(const RunResult& result) {
  const TetrahedralMesh& mesh = result.problem.mesh();
  const Solution& solution = result.solution;
  const Bands& bands = result.problem.bands();
  const std::string unit = UnitLabels(result.input.units).flux;
  vtkSmartPointer<vtkPolyData> surface = separate_triangles(mesh);
  surface->GetCellData()->AddArray(vtk_array({"wall", {}, {}}, mesh.face_walls()));
  add_names(*surface->GetFieldData(), "wall_names", mesh.wall_names());
  add_names(*surface->GetFieldData(), "band_names", bands.names);
  const auto add = [&](const std::string& name, std::span<const double> values) {
    surface->GetPointData()->AddArray(vtk_array({name, bands.names, unit}, bands.count(), values));
  };
  add("irradiance", solution.irradiance);
  if (result.errors) add("irradiance_error", result.errors->irradiance);
  add("exitance", solution.exitance);
  add("net_flux", differences(solution.irradiance, solution.exitance));
  if (are_display_primaries(bands)) {
    const Exposure exposure = exposure_of(solution.exitance, wall_areas(mesh), 3);
    surface->GetPointData()->AddArray(
        vtk_colors(describe(exposure, unit), display_colors(solution.exitance, exposure)));
  }
  return surface;
}

}  // namespace

void write_walls(const RunResult& result, const std::filesystem::path& path,
                 const std::filesystem::path& shown) {
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(fields_of_walls(result));
  write_vtk(*writer, path, shown);
}

}  // namespace etendue
