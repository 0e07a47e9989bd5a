// SPDX-License-Identifier: AGPL-3.0-or-later
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <numeric>

#include "app/write/vtk/vtk_arrays.h"
#include "app/write/vtk/vtk_files.h"
#include "app/write/vtk/vtk_output.h"

namespace etendue {
namespace {

vtkSmartPointer<vtkPoints> points_of_directions(const DirectionSet& set) {
  std::vector<double> coordinates;
  for (const Vec3& direction : set.directions())
    coordinates.insert(coordinates.end(), direction.begin(), direction.end());
  vtkNew<vtkPoints> points;
  points->SetData(vtk_array({"points", {}, {}}, 3, coordinates));
  return points.Get();
}

}  // namespace

void write_directions(const DirectionSet& set, const Case& input, const std::filesystem::path& path) {
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType m = 0; m < set.count(); ++m) vertices->InsertNextCell(1, &m);
  std::vector<std::int32_t> ordinates(static_cast<std::size_t>(set.count()));
  std::iota(ordinates.begin(), ordinates.end(), 0);
  vtkNew<vtkPolyData> sphere;
  sphere->SetPoints(points_of_directions(set));
  sphere->SetVerts(vertices);
  sphere->GetPointData()->AddArray(
      vtk_array({"weight", {}, set.space() == AngularSpace::sphere ? "sr" : "rad"}, 1, set.weights()));
  sphere->GetPointData()->AddArray(vtk_array({"ordinate", {}, {}}, ordinates));
  write_vtk(*sphere, {path, path, input.output.encoding, input.title});
}

}  // namespace etendue
