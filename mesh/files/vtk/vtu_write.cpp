// SPDX-License-Identifier: AGPL-3.0-or-later
#include <unistd.h>

#include <Eigen/Geometry>
#include <initializer_list>
#include <string>
#include <system_error>
#include <utility>

#include <vtkAbstractArray.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include "base/errors.h"
#include "mesh/files/vtk/vtk_write.h"
#include "mesh/files/vtk/vtu_file.h"

namespace etendue {
namespace {

constexpr int kNone = -1;

void add_points(vtkUnstructuredGrid& grid, const TetrahedralMesh& mesh) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(mesh.vertex_count());
  for (int v = 0; v < mesh.vertex_count(); ++v) points->SetPoint(v, mesh.point(VertexIndex(v)).data());
  grid.SetPoints(points);
}

/// VTK wants (p1-p0) x (p2-p0) . (p3-p0) > 0.
std::array<vtkIdType, 4> oriented(const TetrahedralMesh& mesh, CellIndex cell) {
  const auto& v = mesh.vertices(cell);
  const Vec3& p = mesh.point(VertexIndex(v[0]));
  const bool positive = (mesh.point(VertexIndex(v[1])) - p)
                            .cross(mesh.point(VertexIndex(v[2])) - p)
                            .dot(mesh.point(VertexIndex(v[3])) - p) > 0;
  return positive ? std::array<vtkIdType, 4>{v[0], v[1], v[2], v[3]}
                  : std::array<vtkIdType, 4>{v[0], v[1], v[3], v[2]};
}

std::array<vtkIdType, 3> outward(const TetrahedralMesh& mesh, FaceIndex face) {
  const auto& v = mesh.vertices(face);
  const Vec3& p = mesh.point(VertexIndex(v[0]));
  const bool out = (mesh.point(VertexIndex(v[1])) - p)
                       .cross(mesh.point(VertexIndex(v[2])) - p)
                       .dot(mesh.area_normal(face)) > 0;
  return out ? std::array<vtkIdType, 3>{v[0], v[1], v[2]} : std::array<vtkIdType, 3>{v[0], v[2], v[1]};
}

void add_cells(vtkUnstructuredGrid& grid, const TetrahedralMesh& mesh) {
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> types;
  vtkNew<vtkIntArray> regions;
  vtkNew<vtkIntArray> walls;
  vtkNew<vtkStringArray> region_names;
  vtkNew<vtkStringArray> wall_names;
  regions->SetName("region");
  walls->SetName("wall");
  region_names->SetName("region_name");
  wall_names->SetName("wall_name");
  for (int c = 0; c < mesh.cell_count(); ++c) {
    cells->InsertNextCell(4, oriented(mesh, CellIndex(c)).data());
    types->InsertNextValue(VTK_TETRA);
    regions->InsertNextValue(mesh.region(CellIndex(c)));
    walls->InsertNextValue(kNone);
    region_names->InsertNextValue(mesh.region_names()[static_cast<std::size_t>(mesh.region(CellIndex(c)))]);
    wall_names->InsertNextValue("");
  }
  for (int f = 0; f < mesh.boundary_face_count(); ++f) {
    cells->InsertNextCell(3, outward(mesh, FaceIndex(f)).data());
    types->InsertNextValue(VTK_TRIANGLE);
    regions->InsertNextValue(kNone);
    walls->InsertNextValue(mesh.wall(FaceIndex(f)));
    region_names->InsertNextValue("");
    wall_names->InsertNextValue(mesh.wall_names()[static_cast<std::size_t>(mesh.wall(FaceIndex(f)))]);
  }
  grid.SetCells(types, cells);
  for (vtkAbstractArray* array :
       std::initializer_list<vtkAbstractArray*>{regions, walls, region_names, wall_names})
    grid.GetCellData()->AddArray(array);
}

void add_names(vtkUnstructuredGrid& grid, const std::string& title, const std::vector<std::string>& names) {
  vtkNew<vtkStringArray> array;
  array->SetName(title.c_str());
  for (const std::string& name : names) array->InsertNextValue(name);
  grid.GetFieldData()->AddArray(array);
}

/// Writes under a temporary name beside the file, so that a stopped run leaves no half file.
void write_whole(const std::filesystem::path& path, vtkUnstructuredGrid& grid, VtkEncoding encoding) {
  std::filesystem::path unfinished = path;
  unfinished += ".unfinished-" + std::to_string(getpid());
  std::error_code error;
  try {
    write_vtk_file(grid, unfinished, path, encoding, VtkCompression::zlib);
  } catch (const FileError&) {
    std::filesystem::remove(unfinished, error);
    throw;
  }
  std::filesystem::rename(unfinished, path, error);
  if (error) {
    const std::string reason = error.message();
    std::filesystem::remove(unfinished, error);
    throw FileError(path.string(), "cannot be written (" + reason + ")");
  }
}

}  // namespace

void write_vtu_file(const std::filesystem::path& path, const TetrahedralMesh& mesh,
                    const MeshFileOptions& options) {
  vtkNew<vtkUnstructuredGrid> grid;
  add_points(*grid, mesh);
  add_cells(*grid, mesh);
  add_names(*grid, "region_names", mesh.region_names());
  add_names(*grid, "wall_names", mesh.wall_names());
  for (const FieldTexts& field : options.field_texts) add_names(*grid, field.name, field.texts);
  write_whole(path, *grid, options.encoding);
}

}  // namespace etendue
