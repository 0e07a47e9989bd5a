// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "app/case/case.h"
#include "app/write/results.h"
#include "mesh/tetrahedra/cell_locator.h"
#include "solver/sensors/region_account.h"
#include "solver/sensors/sensor_reading.h"

namespace etendue {

/// Throws InputError with each sensor of which nothing lies in the mesh, that names what the mesh does not
/// have, or whose numbers this run cannot have.
void check_sensors(const Case& input, const LightSetup& lights, const CellLocator& locator);

/// Whether a sensor reads the radiance of every ordinate, which the solution must then keep.
bool need_all_ordinates(const std::vector<SensorCase>& sensors);

/// The accounts that sensors keep of regions while a run is solved: the mean over its rotated sets.
class AccountBook {
 public:
  /// The arguments must outlive it.
  AccountBook(const std::vector<SensorCase>& sensors, const LightSetup& lights)
      : sensors_(sensors), lights_(lights) {}

  /// Adds what was found on a set of directions, as SetReader is given it.
  void add(const DirectionSet& directions, const SolveOptions& options, const Solution& solution,
           const AngularInput* input);
  /// The light that directions carried, for the sensor of that number.
  RegionAccount collided(std::size_t sensor) const;

 private:
  const std::vector<SensorCase>& sensors_;
  const LightSetup& lights_;
  int sets_ = 0;
  std::vector<RegionAccount> sums_;  ///< [sensor] empty ones of other kinds
};

/// What sensors look at; `rays` may be empty where there are none.
struct SensorScene {
  const LightSetup& lights;
  const AccountBook& accounts;
  const SolveOptions& options;
  const Solution& solution;
  const std::optional<RayRadiance>& rays;
  const CellLocator& locator;
};

/// What the sensors show; they must have been checked.
std::vector<SensorRow> read_sensors(const std::vector<SensorCase>& sensors, const SensorScene& scene);

}  // namespace etendue
