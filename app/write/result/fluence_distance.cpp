// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/result/fluence_distance.h"

#include <vtkDataArray.h>
#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkStaticCellLocator.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "base/quadrature/cell_rule.h"
#include "mesh/files/vtk/vtk_threads.h"
#include "solver/solution/error_norms.h"

namespace etendue {
namespace {

struct Field {
  vtkSmartPointer<vtkUnstructuredGrid> grid;
  vtkDataArray* fluence = nullptr;  ///< of the points of the grid; null without
};

Field read_field(const std::filesystem::path& path) {
  if (!std::filesystem::exists(path)) return {};
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  Field field{reader->GetOutput()};
  field.fluence = field.grid->GetPointData()->GetArray("fluence");
  return field;
}

/// A cell of a fields.vtu, whose point 4 c + i is its vertex i.
struct CellCorners {
  std::array<Vec3, 4> points;
  double volume;

  CellCorners(vtkUnstructuredGrid& grid, vtkIdType cell) {
    for (vtkIdType i = 0; i < 4; ++i) grid.GetPoint(4 * cell + i, points[static_cast<std::size_t>(i)].data());
    volume = std::abs((points[1] - points[0]).dot((points[2] - points[0]).cross(points[3] - points[0]))) / 6;
  }
};

/// Looks points up in a field; each thread has its own.
class Finder {
 public:
  Finder(const Field& field, vtkStaticCellLocator& locator) : field_(field), locator_(locator) {}

  /// Whether the point lies in a cell, which values() then interpolates in.
  bool find(Vec3 point) {
    std::array<double, 3> parametric;
    return locator_.FindCell(point.data(), 0, cell_, parametric.data(), weights_.data()) >= 0;
  }
  double value(int band) const {
    double sum = 0;
    for (int i = 0; i < 4; ++i)
      sum += weights_[static_cast<std::size_t>(i)] * field_.fluence->GetComponent(cell_->GetPointId(i), band);
    return sum;
  }

 private:
  const Field& field_;
  vtkStaticCellLocator& locator_;
  vtkNew<vtkGenericCell> cell_;
  std::array<double, 4> weights_{};
};

void add_cell(Finder& finder, const Field& other, vtkIdType cell, std::span<ErrorNorms> bands) {
  const CellCorners corners(*other.grid, cell);
  for (const CellRulePoint& node : cell_rule()) {
    if (!finder.find(point_at(node.barycentric, corners.points))) continue;
    for (std::size_t band = 0; band < bands.size(); ++band) {
      double value = 0;
      for (std::size_t i = 0; i < 4; ++i)
        value += node.barycentric[i] *
                 other.fluence->GetComponent(4 * cell + static_cast<vtkIdType>(i), static_cast<int>(band));
      bands[band].add(finder.value(static_cast<int>(band)), value, node.weight * corners.volume);
    }
  }
}

}  // namespace

std::vector<FluenceError> fluence_distance(const std::filesystem::path& fields,
                                           const std::filesystem::path& other_fields) {
  use_vtk_without_threads();
  const Field field = read_field(fields), other = read_field(other_fields);
  if (!field.fluence || !other.fluence ||
      field.fluence->GetNumberOfComponents() != other.fluence->GetNumberOfComponents())
    return {};
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(field.grid);
  locator->BuildLocator();
  // What VTK sets up at the first use must not be met by two threads.
  Finder(field, *locator).find(CellCorners(*field.grid, 0).points[0]);
  const auto bands = static_cast<std::size_t>(field.fluence->GetNumberOfComponents());
  const vtkIdType cells = other.grid->GetNumberOfCells();
  std::vector<ErrorNorms> sums(bands * static_cast<std::size_t>(cells));  // [cell][band]
#pragma omp parallel
  {
    Finder finder(field, *locator);
#pragma omp for schedule(static)
    for (vtkIdType cell = 0; cell < cells; ++cell)
      add_cell(finder, other, cell, std::span(sums).subspan(static_cast<std::size_t>(cell) * bands, bands));
  }
  std::vector<FluenceError> errors;
  for (std::size_t band = 0; band < bands; ++band) {
    ErrorNorms whole;
    for (std::size_t at = band; at < sums.size(); at += bands) whole.add(sums[at]);
    errors.push_back({whole.l2(), whole.maximum()});
  }
  return errors;
}

}  // namespace etendue
