// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "app/case/case.h"
#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/observe/sensors/ordinate_point.h"
#include "solver/observe/sensors/region_account.h"

namespace etendue {

/// Whether a sensor reads the radiance of every ordinate, which the solution must then keep: accounts and the
/// flux through the surface of a region, and in flatland, where there are no rays, all that work there.
bool reads_ordinates(const SensorCase& sensor, AngularSpace space);
bool need_all_ordinates(const std::vector<SensorCase>& sensors, AngularSpace space);

/// What a sensor accounts for: its region, or the faces that its flux goes through. Its names must be those
/// of the mesh.
AccountScope scope_of(const SensorCase& sensor, const TetrahedralMesh& mesh);

/// Tally of the quantities that sensors read from the ordinates during a solve: their means over the rotated
/// sets.
class OrdinateSensorTally {
 public:
  /// The arguments must outlive it.
  OrdinateSensorTally(const std::vector<SensorCase>& sensors, const LightSetup& lights,
                      const CellLocator& locator)
      : sensors_(sensors), lights_(lights), locator_(locator) {}

  /// Adds what was found on a set of directions.
  void add(const SolveOptions& options, const DirectionSetSolution& swept);
  /// The light that directions carried, for the sensor of that number.
  RegionAccount account(std::size_t sensor) const;
  /// The same at the point where a sensor stands.
  OrdinatesAtPoint at_point(std::size_t sensor) const;

 private:
  /// What is added up for a sensor; what its kind does not ask for stays zero.
  struct Sums {
    RegionAccount account;
    OrdinatesAtPoint point;
  };
  void start();

  const std::vector<SensorCase>& sensors_;
  const LightSetup& lights_;
  const CellLocator& locator_;
  int sets_ = 0;
  std::vector<Sums> sums_;  ///< [sensor]
};

}  // namespace etendue
