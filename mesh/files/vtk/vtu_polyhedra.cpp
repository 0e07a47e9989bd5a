// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/files/vtk/vtu_polyhedra.h"

#include <algorithm>
#include <array>

#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkIdTypeArray.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include "mesh/files/vtk/refused_file.h"
#include "mesh/files/vtk/vtu_names.h"
#include "mesh/polyhedra/match_faces.h"

namespace etendue {
namespace {

enum class VtuShape { other, flat, volume };

VtuShape shape_of(int type) {
  switch (type) {
    case VTK_EMPTY_CELL:
    case VTK_VERTEX:
    case VTK_POLY_VERTEX:
    case VTK_LINE:
    case VTK_POLY_LINE:
    case VTK_TRIANGLE:
    case VTK_TRIANGLE_STRIP:
    case VTK_POLYGON:
    case VTK_PIXEL:
    case VTK_QUAD:
      return VtuShape::flat;
    case VTK_TETRA:
    case VTK_VOXEL:
    case VTK_HEXAHEDRON:
    case VTK_WEDGE:
    case VTK_PYRAMID:
    case VTK_PENTAGONAL_PRISM:
    case VTK_HEXAGONAL_PRISM:
    case VTK_POLYHEDRON:
      return VtuShape::volume;
    default:
      return VtuShape::other;
  }
}

/// VTK counts the points of voxels and pixels row by row; the others go round.
constexpr std::array<std::size_t, 8> round_voxel = {0, 1, 3, 2, 4, 5, 7, 6};

class PolyhedraOfVtu {
 public:
  PolyhedraOfVtu(const std::string& file, vtkUnstructuredGrid& grid, VtuNames* names)
      : file_(file), grid_(grid), names_(names) {}

  PolyhedralMesh read() {
    mesh_.file = file_;
    mesh_.points = points_of(grid_);
    for (vtkIdType cell = 0; cell < grid_.GetNumberOfCells(); ++cell) read_cell(cell);
    mesh_.region_names = names_ != nullptr ? names_->region_names() : std::vector<std::string>{"domain"};
    if (names_ != nullptr) mesh_.wall_names = names_->wall_names();
    match_faces(of_cells_, of_walls_, mesh_);
    return std::move(mesh_);
  }

 private:
  void read_cell(vtkIdType cell) {
    switch (grid_.GetCellTypesArray()->GetValue(cell)) {
      case VTK_TETRA:
        return add_pyramid(cell, 3);
      case VTK_PYRAMID:
        return add_pyramid(cell, 4);
      case VTK_WEDGE:
        return add_prism(cell, points_of_cell(file_, grid_, cell, 6));
      case VTK_HEXAHEDRON:
        return add_prism(cell, points_of_cell(file_, grid_, cell, 8));
      case VTK_VOXEL:
        return add_prism(cell, round(points_of_cell(file_, grid_, cell, 8)));
      case VTK_PENTAGONAL_PRISM:
        return add_prism(cell, points_of_cell(file_, grid_, cell, 10));
      case VTK_HEXAGONAL_PRISM:
        return add_prism(cell, points_of_cell(file_, grid_, cell, 12));
      case VTK_POLYHEDRON:
        return add_polyhedron(cell);
      case VTK_PIXEL:
        return add_wall(cell, round(points_of_cell(file_, grid_, cell, 4)));
      case VTK_TRIANGLE:
      case VTK_QUAD:
      case VTK_POLYGON:
        return add_wall(cell, points_of_cell(file_, grid_, cell, 0));
      default:
        return;
    }
  }

  static std::vector<int> round(const std::vector<int>& points) {
    std::vector<int> turned;
    for (std::size_t i = 0; i < points.size(); ++i) turned.push_back(points[round_voxel[i]]);
    return turned;
  }

  /// Numbers the cells with a volume in their order.
  int next_cell(vtkIdType cell) {
    mesh_.cell_regions.push_back(names_ != nullptr ? names_->region(cell) : 0);
    return static_cast<int>(mesh_.cell_regions.size()) - 1;
  }

  /// A base, and a point above it.
  void add_pyramid(vtkIdType cell, std::size_t sides) {
    const std::vector<int> points = points_of_cell(file_, grid_, cell, sides + 1);
    const int owner = next_cell(cell);
    of_cells_.add(owner, std::span(points).first(sides));
    for (std::size_t i = 0; i < sides; ++i)
      of_cells_.add(owner, std::array{points[i], points[(i + 1) % sides], points[sides]});
  }

  /// A base, and the same above it.
  void add_prism(vtkIdType cell, const std::vector<int>& points) {
    const int owner = next_cell(cell);
    const std::size_t sides = points.size() / 2;
    of_cells_.add(owner, std::span(points).first(sides));
    of_cells_.add(owner, std::span(points).last(sides));
    for (std::size_t i = 0; i < sides; ++i) {
      const std::size_t next = (i + 1) % sides;
      of_cells_.add(owner, std::array{points[i], points[next], points[sides + next], points[sides + i]});
    }
  }

  /// Number of faces, then for each the number of its points and these.
  void add_polyhedron(vtkIdType cell) {
    const std::string name = "cell " + std::to_string(cell) + ": ";
    vtkIdTypeArray* stream = grid_.GetFaces();
    vtkIdTypeArray* starts = grid_.GetFaceLocations();
    if (stream == nullptr || starts == nullptr || cell >= starts->GetNumberOfValues())
      refuse_file(file_, name + "a polyhedron without faces");
    vtkIdType at = starts->GetValue(cell);
    const auto next = [&](vtkIdType least, vtkIdType most) {
      if (at < 0 || at >= stream->GetNumberOfValues() || stream->GetValue(at) < least ||
          stream->GetValue(at) > most)
        refuse_file(file_, name + "its list of faces is wrong (is it corrupt?)");
      return stream->GetValue(at++);
    };
    const int owner = next_cell(cell);
    const auto last = static_cast<vtkIdType>(mesh_.points.size()) - 1;
    std::vector<int> face;
    for (vtkIdType left = next(4, stream->GetNumberOfValues()); left > 0; --left) {
      face.clear();
      for (vtkIdType points = next(3, last + 1); points > 0; --points)
        face.push_back(static_cast<int>(next(0, last)));
      of_cells_.add(owner, face);
    }
  }

  void add_wall(vtkIdType cell, const std::vector<int>& points) {
    const int wall = names_ != nullptr ? names_->wall(cell) : -1;
    if (wall != -1) of_walls_.add(wall, points);
  }

  const std::string& file_;
  vtkUnstructuredGrid& grid_;
  VtuNames* names_;  ///< may be null
  Polygons of_cells_, of_walls_;
  PolyhedralMesh mesh_;
};

}  // namespace

std::vector<Vec3> points_of(vtkUnstructuredGrid& grid) {
  vtkPoints* points = grid.GetPoints();
  const vtkIdType count = points == nullptr ? 0 : points->GetNumberOfPoints();
  std::vector<Vec3> places;
  places.reserve(static_cast<std::size_t>(count));
  for (vtkIdType p = 0; p < count; ++p) {
    std::array<double, 3> x{};
    points->GetPoint(p, x.data());
    places.emplace_back(x[0], x[1], x[2]);
  }
  return places;
}

std::vector<int> points_of_cell(const std::string& file, vtkUnstructuredGrid& grid, vtkIdType cell,
                                std::size_t wanted) {
  vtkIdType count = 0;
  const vtkIdType* points = nullptr;
  grid.GetCells()->GetCellAtId(cell, count, points);
  if (wanted != 0 && count != static_cast<vtkIdType>(wanted))
    refuse_file(file, "cell " + std::to_string(cell) + ": has " + std::to_string(count) +
                          " points; must have " + std::to_string(wanted));
  for (vtkIdType i = 0; i < count; ++i)
    if (points[i] < 0 || points[i] >= grid.GetNumberOfPoints())
      refuse_file(file, "cell " + std::to_string(cell) + ": point " + std::to_string(points[i]) +
                            " does not exist; there are " + std::to_string(grid.GetNumberOfPoints()));
  return std::vector<int>(points, points + count);
}

bool has_other_volumes(const std::string& file, vtkUnstructuredGrid& grid) {
  bool found = false;
  vtkUnsignedCharArray& types = *grid.GetCellTypesArray();
  for (vtkIdType cell = 0; cell < grid.GetNumberOfCells(); ++cell) {
    const int type = types.GetValue(cell);
    if (shape_of(type) == VtuShape::other)
      refuse_file(file, "cell " + std::to_string(cell) + ": VTK cell type " + std::to_string(type) +
                            " has curved edges or is unknown; use tetrahedra, hexahedra, wedges, pyramids "
                            "or polyhedra");
    found = found || (shape_of(type) == VtuShape::volume && type != VTK_TETRA);
  }
  return found;
}

std::vector<vtkIdType> volume_cells(vtkUnstructuredGrid& grid) {
  std::vector<vtkIdType> cells;
  for (vtkIdType cell = 0; cell < grid.GetNumberOfCells(); ++cell)
    if (shape_of(grid.GetCellTypesArray()->GetValue(cell)) == VtuShape::volume) cells.push_back(cell);
  return cells;
}

PolyhedralMesh polyhedra_of_vtu(const std::string& file, vtkUnstructuredGrid& grid, VtuNames* names) {
  return PolyhedraOfVtu(file, grid, names).read();
}

}  // namespace etendue
