// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/vtk/fluence_fields.h"

#include <vtkPointData.h>

#include "app/write/vtk/separate_parts.h"
#include "app/write/vtk/vtk_arrays.h"
#include "app/write/vtk/vtk_output.h"

namespace etendue {

void write_fluence_fields(const RunResult& result, const std::vector<FluenceField>& fields,
                          const std::filesystem::path& path, const std::filesystem::path& shown) {
  const Problem& problem = result.problem;
  const Case& input = result.input;
  const auto grid = separate_cells(problem.mesh());
  add_named_cells(*grid, "region", problem.mesh().cell_regions(), problem.mesh().region_names());
  for (const FluenceField& field : fields)
    grid->GetPointData()->AddArray(
        vtk_array({field.name, problem.bands().names, field.unit}, problem.band_count(), field.values));
  add_bands(*grid->GetFieldData(), problem.bands());
  write_vtk(*grid, {path, shown, input.output.encoding, input.title, input.units.length});
}

}  // namespace etendue
