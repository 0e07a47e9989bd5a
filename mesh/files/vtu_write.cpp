// SPDX-License-Identifier: AGPL-3.0-or-later
#include <unistd.h>

#include <Eigen/Geometry>
#include <string>
#include <system_error>
#include <utility>

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
#include <vtkXMLUnstructuredGridWriter.h>

#include "mesh/base/errors.h"
#include "mesh/files/vtk_messages.h"
#include "mesh/files/vtk_threads.h"
#include "mesh/files/vtu_file.h"

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
  regions->SetName("region");
  walls->SetName("wall");
  for (int c = 0; c < mesh.cell_count(); ++c) {
    cells->InsertNextCell(4, oriented(mesh, CellIndex(c)).data());
    types->InsertNextValue(VTK_TETRA);
    regions->InsertNextValue(mesh.region(CellIndex(c)));
    walls->InsertNextValue(kNone);
  }
  for (int f = 0; f < mesh.boundary_face_count(); ++f) {
    cells->InsertNextCell(3, outward(mesh, FaceIndex(f)).data());
    types->InsertNextValue(VTK_TRIANGLE);
    regions->InsertNextValue(kNone);
    walls->InsertNextValue(mesh.wall(FaceIndex(f)));
  }
  grid.SetCells(types, cells);
  grid.GetCellData()->AddArray(regions);
  grid.GetCellData()->AddArray(walls);
}

void add_names(vtkUnstructuredGrid& grid, const char* title, const std::vector<std::string>& names) {
  vtkNew<vtkStringArray> array;
  array->SetName(title);
  for (const std::string& name : names) array->InsertNextValue(name);
  grid.GetFieldData()->AddArray(array);
}

/// Writes under a temporary name beside the file, so that a stopped run leaves no half file.
void write_whole(const std::filesystem::path& path, vtkUnstructuredGrid& grid) {
  std::filesystem::path unfinished = path;
  unfinished += ".unfinished-" + std::to_string(getpid());
  const VtkMessages messages;
  use_vtk_without_threads();
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetFileName(unfinished.c_str());
  writer->SetInputData(&grid);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToZLib();
  std::error_code error;
  if (writer->Write() == 0 || writer->GetErrorCode() != 0 || messages.any()) {
    const std::string reason = messages.any() ? messages.first() : "VTK failed; is the disk full?";
    std::filesystem::remove(unfinished, error);
    throw FileError(path.string(), "cannot be written (" + reason + ")");
  }
  std::filesystem::rename(unfinished, path, error);
  if (error) {
    const std::string reason = error.message();
    std::filesystem::remove(unfinished, error);
    throw FileError(path.string(), "cannot be written (" + reason + ")");
  }
}

}  // namespace

void write_vtu_file(const std::filesystem::path& path, const TetrahedralMesh& mesh) {
  vtkNew<vtkUnstructuredGrid> grid;
  add_points(*grid, mesh);
  add_cells(*grid, mesh);
  add_names(*grid, "region_names", mesh.region_names());
  add_names(*grid, "wall_names", mesh.wall_names());
  write_whole(path, *grid);
}

}  // namespace etendue
