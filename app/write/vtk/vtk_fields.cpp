// SPDX-License-Identifier: AGPL-3.0-or-later
#include <vtkCellData.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>

#include "app/case/temperatures.h"
#include "app/write/result/temperature_fields.h"
#include "app/write/result/unit_labels.h"
#include "app/write/vtk/field_grid.h"
#include "app/write/vtk/separate_parts.h"
#include "app/write/vtk/vtk_arrays.h"
#include "app/write/vtk/vtk_files.h"
#include "app/write/vtk/vtk_output.h"
#include "solver/solution/flux_divergence.h"
#include "solver/solution/node_means.h"

namespace etendue {
namespace {

class FieldsOfCells {
 public:
  explicit FieldsOfCells(const RunResult& result)
      : result_(result),
        units_(result.input.units, result.input.angular_space),
        bands_(result.problem.bands().names),
        grid_(separate_cells(result.problem.mesh())) {}

  vtkSmartPointer<vtkUnstructuredGrid> grid() {
    add_regions();
    if (asked("fluence")) add_fluence();
    if (asked("net_flux")) add_net_flux("net_flux", result_.solution.net_flux);
    if (result_.errors) add_errors(*result_.errors);
    // Sensors may have others kept.
    const std::vector<int>& ordinates = result_.input.output.radiance_ordinates;
    for (const OrdinateRadiance& kept : result_.solution.radiance)
      if (std::ranges::count(ordinates, kept.ordinate) > 0) add_radiance(kept);
    if (asked("media")) add_media();
    if (has_temperatures(result_.input)) add_temperature();
    if (has_temperatures(result_.input) && emits_isotropically(result_.problem)) add_divergence();
    if (const auto& error = result_.solution.direction_error; !error.empty())
      grid_->GetCellData()->AddArray(
          vtk_array({"fluence_direction_error", bands_, units_.flux}, band_count(), error));
    return grid_;
  }

 private:
  bool asked(const std::string& field) const {
    const std::vector<std::string>& fields = result_.input.output.fields;
    return std::find(fields.begin(), fields.end(), field) != fields.end();
  }

  int band_count() const { return static_cast<int>(bands_.size()); }

  void add_regions() {
    const TetrahedralMesh& mesh = result_.problem.mesh();
    add_named_cells(*grid_, "region", mesh.cell_regions(), mesh.region_names());
    add_bands(*grid_->GetFieldData(), result_.problem.bands());
  }

  void add_fluence() {
    const std::vector<double>& fluence = result_.solution.fluence;
    grid_->GetPointData()->AddArray(vtk_array({"fluence", bands_, units_.flux}, band_count(), fluence));
    grid_->GetCellData()->AddArray(vtk_array({"fluence_mean", bands_, units_.flux}, band_count(),
                                             node_means(fluence, 4, bands_.size())));
    if (const auto& uncollided = result_.solution.lights.fluence; !uncollided.empty())
      grid_->GetPointData()->AddArray(
          vtk_array({"fluence_uncollided", bands_, units_.flux}, band_count(), uncollided));
    grid_->GetPointData()->AddArray(
        color_array(result_.problem.bands(), fluence, result_.problem.mesh().volumes(), 4, units_.flux));
  }

  void add_net_flux(const std::string& label, const std::vector<double>& flux) {
    add_band_vectors(*grid_->GetPointData(), {label, bands_, units_.flux}, flux);
  }

  /// Standard errors of what was asked for.
  void add_errors(const RunErrors& errors) {
    if (asked("fluence")) {
      grid_->GetPointData()->AddArray(
          vtk_array({"fluence_error", bands_, units_.flux}, band_count(), errors.fluence));
      grid_->GetCellData()->AddArray(
          vtk_array({"fluence_mean_error", bands_, units_.flux}, band_count(), errors.fluence_mean));
    }
    if (asked("net_flux")) add_net_flux("net_flux_error", errors.net_flux);
  }

  void add_radiance(const OrdinateRadiance& kept) {
    grid_->GetPointData()->AddArray(vtk_array(
        {"radiance_" + std::to_string(kept.ordinate), bands_, units_.radiance}, band_count(), kept.values));
  }

  void add_media() {
    const Problem& problem = result_.problem;
    const auto add = [&](const std::string& name, const std::string& unit, std::span<const double> values) {
      grid_->GetCellData()->AddArray(vtk_array({name, bands_, unit}, band_count(), values));
    };
    add("absorption", units_.coefficient, problem.absorption());
    add("scattering", units_.coefficient, problem.scattering());
    add("emission", units_.emission, problem.emission());
  }

  void add_divergence() {
    const std::string unit = units_.power + "/" + units_.volume;
    grid_->GetCellData()->AddArray(
        vtk_array({"divergence", {}, unit}, 1, flux_divergence(result_.problem, result_.solution)));
  }

  void add_temperature() {
    grid_->GetCellData()->AddArray(vtk_array({"temperature", {}, "K"}, 1, cell_temperatures(result_)));
  }

  const RunResult& result_;
  UnitLabels units_;
  const std::vector<std::string>& bands_;
  vtkSmartPointer<vtkUnstructuredGrid> grid_;
};

}  // namespace

vtkSmartPointer<vtkUnstructuredGrid> field_grid(const RunResult& result) {
  return FieldsOfCells(result).grid();
}

void write_fields(const RunResult& result, const std::filesystem::path& path,
                  const std::filesystem::path& shown) {
  const Case& input = result.input;
  write_vtk(*field_grid(result), {path, shown, input.output.encoding, input.title, input.units.length});
}

}  // namespace etendue
