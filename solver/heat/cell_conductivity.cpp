// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/heat/cell_conductivity.h"

#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <string>

#include "mesh/tetrahedra/corners.h"

namespace etendue {

double cell_conductivity(const HeatMedium& medium, const TetrahedralMesh& mesh, CellIndex cell,
                         const std::array<double, 4>& kelvin) {
  const CellSample sample = medium.conductivity.sample(corners_of(mesh, cell), kelvin);
  if (std::isfinite(sample.mean) && sample.smallest >= 0) return sample.mean;
  const std::string temperature =
      medium.conductivity.depends_on_temperature()
          ? fmt::format(" and {:.6g} K", std::accumulate(kelvin.begin(), kelvin.end(), 0.0) / 4)
          : "";
  throw InputError(
      fault_at(medium.origin, "conductivity",
               fmt::format("is {:g} at ({:.6g}, {:.6g}, {:.6g}){}; use at least 0", sample.smallest,
                           sample.where.x(), sample.where.y(), sample.where.z(), temperature)));
}

}  // namespace etendue
