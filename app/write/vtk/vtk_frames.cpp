// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>
#include <vtkPointData.h>

#include "app/write/result/unit_labels.h"
#include "app/write/vtk/separate_parts.h"
#include "app/write/vtk/vtk_arrays.h"
#include "app/write/vtk/vtk_files.h"
#include "app/write/vtk/vtk_output.h"

namespace etendue {

std::string frame_name(std::size_t frame) { return fmt::format("fluence_{:04}.vtu", frame + 1); }

void write_frame(const RunResult& result, const FrameInTime& frame, const std::filesystem::path& path,
                 const std::filesystem::path& shown) {
  const Problem& problem = result.problem;
  const Case& input = result.input;
  const auto grid = separate_cells(problem.mesh());
  add_named_cells(*grid, "region", problem.mesh().cell_regions(), problem.mesh().region_names());
  const UnitLabels units(input.units, input.angular_space);
  grid->GetPointData()->AddArray(
      vtk_array({"fluence", problem.bands().names, units.flux}, problem.band_count(), frame.fluence));
  add_bands(*grid->GetFieldData(), problem.bands());
  write_vtk(*grid, {path, shown, input.output.encoding, input.title, input.units.length});
}

std::string frames_pvd(const StepsInTime& steps) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n  <Collection>\n";
  for (std::size_t i = 0; i < steps.frames.size(); ++i)
    text += fmt::format("    <DataSet timestep=\"{}\" file=\"{}\"/>\n", steps.frames[i].time, frame_name(i));
  return text + "  </Collection>\n</VTKFile>\n";
}

}  // namespace etendue
