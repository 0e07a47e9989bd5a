// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>

#include "app/write/result/unit_labels.h"
#include "app/write/vtk/point_fields.h"
#include "app/write/vtk/vtk_files.h"

namespace etendue {

std::string frame_name(const StepsInTime& steps, std::size_t frame) {
  return fmt::format("{}_{:04}.vtu", steps.of, frame + 1);
}

void write_frame(const RunResult& result, const FrameInTime& frame, const std::filesystem::path& path,
                 const std::filesystem::path& shown) {
  const UnitLabels units(result.input.units, result.input.angular_space);
  const bool of_light = result.time->steps->of == "fluence";
  write_point_fields(result, {{result.time->steps->of, of_light ? units.flux : "K", frame.values, of_light}},
                     path, shown);
}

std::string frames_pvd(const StepsInTime& steps) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n  <Collection>\n";
  for (std::size_t i = 0; i < steps.frames.size(); ++i)
    text += fmt::format("    <DataSet timestep=\"{}\" file=\"{}\"/>\n", steps.frames[i].time,
                        frame_name(steps, i));
  return text + "  </Collection>\n</VTKFile>\n";
}

}  // namespace etendue
