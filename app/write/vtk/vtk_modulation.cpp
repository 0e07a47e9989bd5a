// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>
#include <vtkPointData.h>

#include <complex>

#include "app/write/result/unit_labels.h"
#include "app/write/vtk/separate_parts.h"
#include "app/write/vtk/vtk_arrays.h"
#include "app/write/vtk/vtk_files.h"
#include "app/write/vtk/vtk_output.h"

namespace etendue {

void write_modulation(const RunResult& result, const std::filesystem::path& path,
                      const std::filesystem::path& shown) {
  const Problem& problem = result.problem;
  const Case& input = result.input;
  const auto grid = separate_cells(problem.mesh());
  add_named_cells(*grid, "region", problem.mesh().cell_regions(), problem.mesh().region_names());
  const UnitLabels units(input.units, input.angular_space);
  const auto add = [&](const std::string& name, const std::string& unit, const std::vector<double>& values) {
    grid->GetPointData()->AddArray(
        vtk_array({name, problem.bands().names, unit}, problem.band_count(), values));
  };
  for (const ModulatedLight& light : result.time->modulated) {
    std::vector<double> amplitude, phase;
    for (std::size_t i = 0; i < light.fluence.size(); i += 2) {
      const std::complex<double> value(light.fluence[i], light.fluence[i + 1]);
      amplitude.push_back(std::abs(value));
      phase.push_back(phase_of(value));
    }
    add(fmt::format("amplitude_{}", light.frequency), units.flux, amplitude);
    if (light.frequency > 0) add(fmt::format("phase_{}", light.frequency), "degree", phase);
  }
  add_bands(*grid->GetFieldData(), problem.bands());
  write_vtk(*grid, {path, shown, input.output.encoding, input.title, input.units.length});
}

}  // namespace etendue
