// SPDX-License-Identifier: AGPL-3.0-or-later
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include "app/write/image/color.h"
#include "app/write/vtk/baked_surface.h"
#include "app/write/vtk/vtk_arrays.h"
#include "app/write/vtk/vtk_output.h"

namespace etendue {

void write_baked(const BakedSurface& baked, const std::string& unit, const Case& input,
                 const std::filesystem::path& path, const std::filesystem::path& shown) {
  std::vector<double> positions, normals, colors;
  for (const WallSurface::Vertex& vertex : baked.surface.vertices) {
    positions.insert(positions.end(), vertex.position.begin(), vertex.position.end());
    normals.insert(normals.end(), vertex.normal.begin(), vertex.normal.end());
  }
  for (const LinearColor& color : baked.colors) colors.insert(colors.end(), color.begin(), color.end());
  vtkNew<vtkPoints> points;
  points->SetData(vtk_array({"points", {}, {}}, 3, positions));
  vtkNew<vtkCellArray> triangles;
  for (const std::array<std::int32_t, 3>& triangle : baked.surface.triangles) {
    const std::array<vtkIdType, 3> corners = {triangle[0], triangle[1], triangle[2]};
    triangles->InsertNextCell(3, corners.data());
  }
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  surface->GetPointData()->AddArray(vtk_array({"normal", {"x", "y", "z"}, {}}, 3, normals));
  for (std::size_t n = 0; n < baked.names.size(); ++n) {
    std::vector<double> values;
    for (std::size_t at = n; at < baked.values.size(); at += baked.names.size())
      values.push_back(baked.values[at]);
    surface->GetPointData()->AddArray(vtk_array({baked.names[n], {}, unit}, 1, values));
  }
  surface->GetPointData()->AddArray(vtk_colors(baked.comment, display_colors(colors, Exposure{1})));
  write_vtk(*surface, {path, shown, input.output.encoding, input.title, input.units.length});
}

}  // namespace etendue
