// SPDX-License-Identifier: AGPL-3.0-or-later
#include <array>
#include <cmath>
#include <limits>
#include <new>
#include <string>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include "base/errors.h"
#include "base/name_table.h"
#include "mesh/files/vtk/vtk_messages.h"
#include "mesh/files/vtk/vtu_grid.h"

namespace etendue {
namespace {

class VtuReader {
 public:
  explicit VtuReader(const std::filesystem::path& path) : file_(path.string()) {}

  RawMesh read() {
    read_grid();
    const vtkIdType cells = grid_->GetNumberOfCells();
    types_ = grid_->GetCellTypesArray();
    regions_ = integers("region");
    walls_ = integers("wall");
    region_names_ = names("region_names", used_regions_);
    wall_names_ = names("wall_names", used_walls_);
    mesh_.file = file_;
    read_points();
    check_offsets(cells);
    for (vtkIdType cell = 0; cell < cells; ++cell) read_cell(cell);
    mesh_.region_names = used_regions_.names();
    mesh_.wall_names = used_walls_.names();
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void fail(const std::string& problem) const { throw InputError(Fault{file_, 0, problem}); }

  void read_grid() {
    const VtkMessages messages;
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    reader->SetFileName(file_.c_str());
    try {
      reader->Update();
    } catch (const std::bad_alloc&) {
      fail("VTK needs more memory than there is to read it (is it corrupt?)");
    }
    grid_ = reader->GetOutput();
    if (messages.any() || reader->GetErrorCode() != 0)
      fail("VTK cannot read it (" + messages.first() + "); is it cut short or corrupt?");
    if (grid_ == nullptr || grid_->GetNumberOfCells() == 0) fail("holds no cells; mesh the volume");
  }

  vtkDataArray* integers(const char* name) const {
    vtkAbstractArray* found = grid_->GetCellData()->GetAbstractArray(name);
    if (found == nullptr) return nullptr;
    vtkDataArray* array = vtkDataArray::SafeDownCast(found);
    if (array == nullptr || array->GetNumberOfComponents() != 1 ||
        array->GetNumberOfTuples() != grid_->GetNumberOfCells())
      fail(std::string("cell array ") + name + ": must be one integer for each cell");
    return array;
  }

  /// Also enters the names into the table in the order of the file.
  vtkStringArray* names(const char* name, NameTable& table) const {
    vtkAbstractArray* found = grid_->GetFieldData()->GetAbstractArray(name);
    if (found == nullptr) return nullptr;
    vtkStringArray* array = vtkStringArray::SafeDownCast(found);
    if (array == nullptr) fail(std::string("field array ") + name + ": must hold strings");
    for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i) table.index(array->GetValue(i));
    return array;
  }

  void read_points() {
    vtkPoints* points = grid_->GetPoints();
    const vtkIdType count = points == nullptr ? 0 : points->GetNumberOfPoints();
    mesh_.points.reserve(static_cast<std::size_t>(count));
    for (vtkIdType p = 0; p < count; ++p) {
      std::array<double, 3> x{};
      points->GetPoint(p, x.data());
      mesh_.points.emplace_back(x[0], x[1], x[2]);
    }
  }

  /// VTK follows offsets without looking where they lead.
  void check_offsets(vtkIdType cells) const {
    vtkCellArray* array = grid_->GetCells();
    vtkDataArray* offsets = array->GetOffsetsArray();
    const vtkIdType entries = array->GetConnectivityArray()->GetNumberOfTuples();
    if (types_ == nullptr || types_->GetNumberOfTuples() != cells ||
        offsets->GetNumberOfTuples() != cells + 1)
      fail("cell types and offsets: must be one for each cell (is it corrupt?)");
    for (vtkIdType cell = 0; cell < cells; ++cell) {
      const double first = offsets->GetTuple1(cell);
      const double last = offsets->GetTuple1(cell + 1);
      if (!(first >= 0 && first <= last && last <= static_cast<double>(entries)))
        fail("cell " + std::to_string(cell) + ": its offset leads outside the connectivity (is it corrupt?)");
    }
  }

  template <std::size_t N>
  std::array<int, N> points_of(vtkIdType cell) const {
    vtkIdType count = 0;
    const vtkIdType* points = nullptr;
    grid_->GetCells()->GetCellAtId(cell, count, points);
    if (count != static_cast<vtkIdType>(N))
      fail("cell " + std::to_string(cell) + ": has " + std::to_string(count) + " points; must have " +
           std::to_string(N));
    std::array<int, N> result{};
    for (std::size_t i = 0; i < N; ++i) {
      if (points[i] < 0 || points[i] >= static_cast<vtkIdType>(mesh_.points.size()))
        fail("cell " + std::to_string(cell) + ": point " + std::to_string(points[i]) +
             " does not exist; there are " + std::to_string(mesh_.points.size()));
      result[i] = static_cast<int>(points[i]);
    }
    return result;
  }

  /// The number that a cell has in an array.
  std::int64_t number(vtkDataArray* array, vtkIdType cell, const char* what) const {
    const double value = array->GetTuple1(cell);
    if (!(std::abs(value) <= std::numeric_limits<std::int32_t>::max()) || value != std::floor(value))
      fail("cell " + std::to_string(cell) + ": " + what + " = " + std::to_string(value) +
           ": must be an integer");
    return static_cast<std::int64_t>(value);
  }

  std::string name(vtkStringArray* names, std::int64_t number, vtkIdType cell,
                   const std::string& what) const {
    if (names == nullptr) return std::to_string(number);
    if (number < 0 || number >= names->GetNumberOfValues())
      fail("cell " + std::to_string(cell) + ": " + what + " = " + std::to_string(number) +
           ": has no name; there are " + std::to_string(names->GetNumberOfValues()) + " in " + what +
           "_names");
    return names->GetValue(number);
  }

  void read_tetrahedron(vtkIdType cell) {
    mesh_.cells.push_back(points_of<4>(cell));
    mesh_.cell_numbers.push_back(cell);
    const std::string region = regions_ == nullptr
                                   ? "domain"
                                   : name(region_names_, number(regions_, cell, "region"), cell, "region");
    mesh_.cell_regions.push_back(used_regions_.index(region));
  }

  void read_triangle(vtkIdType cell) {
    const std::array<int, 3> points = points_of<3>(cell);
    const std::int64_t wall = walls_ == nullptr ? -1 : number(walls_, cell, "wall");
    if (wall == -1) return;
    mesh_.triangles.push_back(points);
    mesh_.triangle_walls.push_back(used_walls_.index(name(wall_names_, wall, cell, "wall")));
  }

  void read_cell(vtkIdType cell) {
    switch (types_->GetValue(cell)) {
      case VTK_TETRA:
        return read_tetrahedron(cell);
      case VTK_TRIANGLE:
        return read_triangle(cell);
      case VTK_EMPTY_CELL:
      case VTK_VERTEX:
      case VTK_POLY_VERTEX:
      case VTK_LINE:
      case VTK_POLY_LINE:
      case VTK_TRIANGLE_STRIP:
      case VTK_POLYGON:
      case VTK_PIXEL:
      case VTK_QUAD:
        return;
      default:
        fail("cell " + std::to_string(cell) + ": VTK cell type " + std::to_string(types_->GetValue(cell)) +
             " is not a tetrahedron of first order; mesh the volume with those");
    }
  }

  std::string file_;
  vtkSmartPointer<vtkUnstructuredGrid> grid_;
  vtkUnsignedCharArray* types_ = nullptr;
  vtkDataArray* regions_ = nullptr;
  vtkDataArray* walls_ = nullptr;
  vtkStringArray* region_names_ = nullptr;
  vtkStringArray* wall_names_ = nullptr;
  NameTable used_regions_;
  NameTable used_walls_;
  RawMesh mesh_;
};

}  // namespace

RawMesh read_vtu_grid(const std::filesystem::path& path) { return VtuReader(path).read(); }

}  // namespace etendue
