// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/vtk/point_fields.h"

#include <vtkPointData.h>

#include "app/write/vtk/separate_parts.h"
#include "app/write/vtk/vtk_arrays.h"
#include "app/write/vtk/vtk_output.h"

namespace etendue {

void write_point_fields(const RunResult& result, const std::vector<PointField>& fields,
                        const std::filesystem::path& path, const std::filesystem::path& shown) {
  const Problem& problem = result.problem;
  const Case& input = result.input;
  const auto grid = separate_cells(problem.mesh());
  add_named_cells(*grid, "region", problem.mesh().cell_regions(), problem.mesh().region_names());
  for (const PointField& field : fields) {
    const std::vector<std::string> names =
        field.by_bands ? problem.bands().names : std::vector<std::string>();
    grid->GetPointData()->AddArray(
        vtk_array({field.name, names, field.unit}, field.by_bands ? problem.band_count() : 1, field.values));
  }
  add_bands(*grid->GetFieldData(), problem.bands());
  write_vtk(*grid, {path, shown, input.output.encoding, input.title, input.units.length});
}

}  // namespace etendue
