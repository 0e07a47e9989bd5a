// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>

#include <complex>
#include <utility>

#include "app/write/result/unit_labels.h"
#include "app/write/vtk/point_fields.h"
#include "app/write/vtk/vtk_files.h"

namespace etendue {

void write_modulation(const RunResult& result, const std::filesystem::path& path,
                      const std::filesystem::path& shown) {
  const UnitLabels units(result.input.units, result.input.angular_space);
  std::vector<PointField> fields;
  for (const ModulatedLight& light : result.time->modulated) {
    std::vector<double> amplitude, phase;
    for (std::size_t i = 0; i < light.fluence.size(); i += 2) {
      const std::complex<double> value(light.fluence[i], light.fluence[i + 1]);
      amplitude.push_back(std::abs(value));
      phase.push_back(phase_of(value));
    }
    fields.push_back({fmt::format("amplitude_{}", light.frequency), units.flux, std::move(amplitude)});
    if (light.frequency > 0)
      fields.push_back({fmt::format("phase_{}", light.frequency), "degree", std::move(phase)});
  }
  write_point_fields(result, fields, path, shown);
}

}  // namespace etendue
