// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/files/fields/field_grid.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkDataSetTriangleFilter.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>

#include "base/errors.h"
#include "mesh/files/openfoam/foam_mesh.h"
#include "mesh/files/vtk/refused_file.h"
#include "mesh/files/vtk/vtk_cell_check.h"
#include "mesh/files/vtk/vtk_data_set.h"
#include "mesh/files/vtk/vtu_polyhedra.h"
#include "mesh/tetrahedra/generation/cut_polyhedra.h"

namespace etendue {
namespace {

/// Picks and copies one array of a data set.
class FieldReader {
 public:
  explicit FieldReader(const FieldRequest& request)
      : request_(request), data_(read_data_set(request.path, request.time)) {}

  FieldData read() {
    if (data_ == nullptr || data_->GetNumberOfPoints() == 0 || data_->GetNumberOfCells() == 0)
      fail("holds no cells");
    choose_array();
    if (auto* image = vtkImageData::SafeDownCast(data_)) return of_image(*image);
    return of_tetrahedra(*vtkUnstructuredGrid::SafeDownCast(data_));
  }

 private:
  [[noreturn]] void fail(const std::string& problem) const { refuse_file(request_.path, problem); }

  vtkDataSetAttributes& attributes(FieldValues on) const {
    if (on == FieldValues::on_points) return *data_->GetPointData();
    return *data_->GetCellData();
  }

  static std::string names_in(vtkDataSetAttributes& attributes) {
    std::string names;
    for (int i = 0; i < attributes.GetNumberOfArrays(); ++i)
      if (const char* name = attributes.GetArrayName(i))
        names += (names.empty() ? "" : ", ") + std::string(name);
    return names.empty() ? "none" : names;
  }

  [[noreturn]] void fail_without_array() const {
    const char* where = !request_.on                            ? "array"
                        : *request_.on == FieldValues::on_cells ? "cell array"
                                                                : "point array";
    fail("holds no " + std::string(where) + " \"" + request_.array +
         "\"; on cells: " + names_in(attributes(FieldValues::on_cells)) +
         "; on points: " + names_in(attributes(FieldValues::on_points)));
  }

  /// The only array of the file, of any name.
  void choose_only_array() {
    const int on_cells = data_->GetCellData()->GetNumberOfArrays(),
              on_points = data_->GetPointData()->GetNumberOfArrays();
    if (on_cells + on_points != 1)
      fail("holds several arrays or none; choose one by `array` (on cells: " +
           names_in(attributes(FieldValues::on_cells)) +
           "; on points: " + names_in(attributes(FieldValues::on_points)) + ")");
    on_ = on_cells == 1 ? FieldValues::on_cells : FieldValues::on_points;
    index_ = 0;
  }

  void choose_named_array() {
    for (const FieldValues on : {FieldValues::on_cells, FieldValues::on_points}) {
      if (request_.on && *request_.on != on) continue;
      attributes(on).GetAbstractArray(request_.array.c_str(), index_);
      on_ = on;
      if (index_ >= 0) return;
    }
    fail_without_array();
  }

  void choose_array() {
    if (request_.array.empty())
      choose_only_array();
    else
      choose_named_array();
    vtkDataArray* array = attributes(on_).GetArray(index_);
    if (array == nullptr) fail("array \"" + request_.array + "\": holds no numbers");
    const vtkIdType wanted =
        on_ == FieldValues::on_cells ? data_->GetNumberOfCells() : data_->GetNumberOfPoints();
    if (array->GetNumberOfTuples() != wanted)
      fail("array \"" + request_.array + "\": has " + std::to_string(array->GetNumberOfTuples()) +
           " entries; must have " + std::to_string(wanted) + " (is it corrupt?)");
    const int components = array->GetNumberOfComponents();
    if (!request_.component && components > 1)
      fail("array \"" + request_.array + "\": has " + std::to_string(components) +
           " components; choose one by `component`, from 0 to " + std::to_string(components - 1));
    component_ = request_.component.value_or(0);
    if (component_ >= components)
      fail("array \"" + request_.array + "\": has no component " + std::to_string(component_) +
           "; they are counted from 0 to " + std::to_string(components - 1));
  }

  std::vector<double> values_of(vtkDataSetAttributes& attributes) const {
    vtkDataArray& array = *attributes.GetArray(index_);
    std::vector<double> values(static_cast<std::size_t>(array.GetNumberOfTuples()));
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = array.GetComponent(static_cast<vtkIdType>(i), component_);
    return values;
  }

  /// The values of a NIfTI image are those of voxels around its points.
  bool holds_voxels() const { return request_.path.extension() != ".vti" && on_ == FieldValues::on_points; }

  FieldData of_image(vtkImageData& image) const {
    FieldData field;
    ImageGrid& grid = field.image.emplace();
    const int* extent = image.GetExtent();
    const bool voxels = holds_voxels();
    for (int axis = 0; axis < 3; ++axis) {
      grid.points[static_cast<std::size_t>(axis)] = image.GetDimensions()[axis] + (voxels ? 1 : 0);
      for (int i = 0; i < 3; ++i)
        grid.steps(i, axis) = image.GetDirectionMatrix()->GetElement(i, axis) * image.GetSpacing()[axis];
    }
    grid.origin = Vec3(image.GetOrigin()[0], image.GetOrigin()[1], image.GetOrigin()[2]) +
                  grid.steps * Vec3(extent[0], extent[2], extent[4]);
    if (voxels) grid.origin -= 0.5 * grid.steps * Vec3::Ones();
    for (const int points : grid.points)
      if (points < 2) fail("is flat; must have at least two points along each axis");
    if (!(std::abs(grid.steps.determinant()) > 0)) fail("its spacing is 0 or its axes lie in a plane");
    field.on = voxels ? FieldValues::on_cells : on_;
    field.values = values_of(attributes(on_));
    return field;
  }

  /// The folder of the OpenFOAM case that is read; empty: the file is of another program.
  std::optional<std::filesystem::path> foam_folder() const {
    const std::filesystem::path& path = request_.path;
    if (std::filesystem::is_directory(path)) return path;
    if (path.extension() == ".foam") return std::filesystem::absolute(path).parent_path();
    if (path.filename() == "controlDict") return std::filesystem::absolute(path).parent_path().parent_path();
    return std::nullopt;
  }

  /// The tetrahedra that the mesh of the same file has: a value of its cells is that of their parts, up to
  /// the boundary of cells whose faces are not flat. VTK rounds the points of OpenFOAM to single precision.
  /// Empty where the cells have no such cut; VTK may have one.
  std::optional<FieldData> of_polyhedra(vtkUnstructuredGrid& grid) const try {
    const std::string file = request_.path.string();
    const auto foam = foam_folder();
    if (on_ != FieldValues::on_cells || (!foam && !has_other_volumes(file, grid))) return std::nullopt;
    const std::vector<vtkIdType> parents = volume_cells(grid);
    auto whole = std::make_shared<const PolyhedralMesh>(foam ? read_foam_mesh(*foam)
                                                             : polyhedra_of_vtu(file, grid, nullptr));
    if (whole->cell_count() != parents.size()) return std::nullopt;
    const RawMesh parts = cut_polyhedra(std::move(whole));
    FieldData field;
    field.on = on_;
    field.points = parts.points;
    field.cells = parts.cells;
    const std::vector<double> values = values_of(*grid.GetCellData());
    for (const std::int32_t parent : parts.parents.cells)
      field.values.push_back(values[static_cast<std::size_t>(parents[static_cast<std::size_t>(parent)])]);
    return field;
  } catch (const InputError&) {
    return std::nullopt;
  } catch (const FileError&) {
    return std::nullopt;
  }

  FieldData of_tetrahedra(vtkUnstructuredGrid& grid) const {
    if (const std::string problem = cell_problem(grid); !problem.empty()) fail(problem);
    if (std::optional<FieldData> field = of_polyhedra(grid)) return *field;
    const vtkNew<vtkDataSetTriangleFilter> filter;
    filter->SetInputData(&grid);
    filter->TetrahedraOnlyOn();
    filter->Update();
    vtkUnstructuredGrid& cut = *filter->GetOutput();
    FieldData field;
    field.on = on_;
    for (vtkIdType p = 0; p < cut.GetNumberOfPoints(); ++p) {
      std::array<double, 3> x{};
      cut.GetPoint(p, x.data());
      field.points.emplace_back(x[0], x[1], x[2]);
      if (!field.points.back().allFinite())
        fail("point " + std::to_string(p) + ": is not finite (is it corrupt?)");
    }
    for (vtkIdType c = 0; c < cut.GetNumberOfCells(); ++c) {
      vtkIdType count = 0;
      const vtkIdType* points = nullptr;
      cut.GetCellPoints(c, count, points);
      field.cells.push_back({static_cast<int>(points[0]), static_cast<int>(points[1]),
                             static_cast<int>(points[2]), static_cast<int>(points[3])});
    }
    if (field.cells.empty()) fail("holds no cells with a volume");
    field.values =
        values_of(on_ == FieldValues::on_points ? static_cast<vtkDataSetAttributes&>(*cut.GetPointData())
                                                : static_cast<vtkDataSetAttributes&>(*cut.GetCellData()));
    return field;
  }

  const FieldRequest& request_;
  vtkSmartPointer<vtkDataSet> data_;
  FieldValues on_ = FieldValues::on_cells;
  int index_ = -1;
  int component_ = 0;
};

}  // namespace

FieldData read_field_by_vtk(const FieldRequest& request) { return FieldReader(request).read(); }

}  // namespace etendue
