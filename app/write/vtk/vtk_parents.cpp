// SPDX-License-Identifier: AGPL-3.0-or-later
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include <string_view>

#include "app/write/parents/parent_means.h"
#include "app/write/result/unit_labels.h"
#include "app/write/vtk/field_grid.h"
#include "app/write/vtk/vtk_arrays.h"
#include "app/write/vtk/vtk_files.h"
#include "app/write/vtk/vtk_output.h"
#include "base/position.h"
#include "mesh/polyhedra/cell_shape.h"
#include "solver/solution/node_means.h"

namespace etendue {
namespace {

int vtk_type(const CellShape& shape) {
  if (shape.kind == CellKind::pyramid) return shape.points.size() == 4 ? VTK_TETRA : VTK_PYRAMID;
  if (shape.kind == CellKind::prism) return shape.points.size() == 6 ? VTK_WEDGE : VTK_HEXAHEDRON;
  return VTK_POLYHEDRON;
}

void insert_polyhedron(const PolyhedralMesh& mesh, std::span<const FaceOfCell> faces,
                       vtkUnstructuredGrid& grid) {
  std::vector<vtkIdType> stream;
  for (const FaceOfCell& face : faces) {
    const std::vector<int> points = outward_points(mesh, face);
    stream.push_back(static_cast<vtkIdType>(points.size()));
    stream.insert(stream.end(), points.begin(), points.end());
  }
  grid.InsertNextCell(VTK_POLYHEDRON, static_cast<vtkIdType>(faces.size()), stream.data());
}

void insert_cell(const PolyhedralMesh& mesh, std::span<const FaceOfCell> faces, vtkUnstructuredGrid& grid) {
  const CellShape shape = shape_of_cell(mesh, faces);
  const int type = vtk_type(shape);
  if (type == VTK_POLYHEDRON) return insert_polyhedron(mesh, faces, grid);
  std::vector<vtkIdType> points(shape.points.begin(), shape.points.end());
  // The base of a wedge of VTK is seen from below.
  if (type == VTK_WEDGE) {
    std::swap(points[1], points[2]);
    std::swap(points[4], points[5]);
  }
  grid.InsertNextCell(type, static_cast<vtkIdType>(points.size()), points.data());
}

vtkSmartPointer<vtkUnstructuredGrid> grid_of_parents(const PolyhedralMesh& mesh) {
  std::vector<double> coordinates;
  for (const Vec3& point : mesh.points) coordinates.insert(coordinates.end(), point.begin(), point.end());
  vtkNew<vtkPoints> points;
  points->SetData(vtk_array({"points", {}, {}}, 3, coordinates));
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(points);
  grid->Allocate(static_cast<vtkIdType>(mesh.cell_count()));
  const FacesOfCells faces(mesh);
  for (std::size_t c = 0; c < mesh.cell_count(); ++c) insert_cell(mesh, faces.of(c), *grid);
  return grid.Get();
}

ArrayLabel label_of(vtkDataArray& array) {
  ArrayLabel label{array.GetName(), {}, {}};
  for (int k = 0; array.HasAComponentName() && k < array.GetNumberOfComponents(); ++k)
    label.components.emplace_back(array.GetComponentName(k));
  if (array.HasInformation() && array.GetInformation()->Has(vtkDataArray::UNITS_LABEL()))
    label.unit = array.GetInformation()->Get(vtkDataArray::UNITS_LABEL());
  return label;
}

/// Adds the means of the arrays of fields.vtu, where means say something: not of errors.
class MeansOfParents {
 public:
  MeansOfParents(const TetrahedralMesh& mesh, vtkUnstructuredGrid& grid) : mesh_(mesh), grid_(grid) {}

  void add(vtkUnstructuredGrid& fields) {
    for_each_array(*fields.GetCellData(), [&](vtkDoubleArray& array) { add_mean(array, 1); });
    for_each_array(*fields.GetPointData(), [&](vtkDoubleArray& array) {
      if (std::string_view(array.GetName()).starts_with("net_flux")) add_mean(array, 4);
    });
  }

 private:
  template <class Use>
  static void for_each_array(vtkDataSetAttributes& arrays, const Use& use) {
    for (int i = 0; i < arrays.GetNumberOfArrays(); ++i)
      if (auto* array = vtkDoubleArray::SafeDownCast(arrays.GetAbstractArray(i)))
        if (std::string_view(array->GetName()).find("_error") == std::string_view::npos) use(*array);
  }

  void add_mean(vtkDoubleArray& array, std::size_t nodes) {
    const auto components = static_cast<std::size_t>(array.GetNumberOfComponents());
    const std::span<const double> values(array.GetPointer(0), static_cast<std::size_t>(array.GetDataSize()));
    const std::vector<double> of_cells = node_means(values, nodes, components);
    grid_.GetCellData()->AddArray(
        vtk_array(label_of(array), array.GetNumberOfComponents(), parent_means(mesh_, of_cells, components)));
  }

  const TetrahedralMesh& mesh_;
  vtkUnstructuredGrid& grid_;
};

}  // namespace

void write_parents(const RunResult& result, const std::filesystem::path& path,
                   const std::filesystem::path& shown) {
  const Case& input = result.input;
  const TetrahedralMesh& mesh = result.problem.mesh();
  const vtkSmartPointer<vtkUnstructuredGrid> grid = grid_of_parents(*mesh.parents().mesh);
  add_named_cells(*grid, "region", parent_regions(mesh), mesh.region_names());
  add_bands(*grid->GetFieldData(), result.problem.bands());
  grid->GetCellData()->AddArray(vtk_array({"volume", {}, UnitLabels(input.units, input.angular_space).volume},
                                          1, parent_volumes(mesh)));
  MeansOfParents(mesh, *grid).add(*field_grid(result));
  write_vtk(*grid, {path, shown, input.output.encoding, input.title, input.units.length});
}

}  // namespace etendue
