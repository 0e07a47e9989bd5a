// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/readings/ordinate_sensor_tally.h"

#include <algorithm>

#include "base/vector_sums.h"

namespace etendue {
namespace {

/// The place of a name; -1 where it is not among them.
int number_of(const std::string& name, const std::vector<std::string>& names) {
  const auto found = std::ranges::find(names, name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

/// Directions of travel that count.
std::optional<Cone> travel_of(const SensorCase& sensor) {
  if (sensor.sensor.half_angle > 0) return Cone{-sensor.sensor.direction, sensor.sensor.half_angle};
  return std::nullopt;
}

bool has_point(const SensorCase& sensor) {
  return sensor.sensor.kind == SensorKind::irradiance || sensor.sensor.kind == SensorKind::fluence;
}

}  // namespace

bool reads_ordinates(const SensorCase& sensor, AngularSpace space) {
  if (sensor.sensor.kind == SensorKind::region) return true;
  if (sensor.sensor.kind == SensorKind::flux && !sensor.region.empty()) return true;
  return space == AngularSpace::plane;
}

bool need_all_ordinates(const std::vector<SensorCase>& sensors, AngularSpace space) {
  return std::ranges::any_of(sensors,
                             [&](const SensorCase& sensor) { return reads_ordinates(sensor, space); });
}

AccountScope scope_of(const SensorCase& sensor, const TetrahedralMesh& mesh) {
  const int region = number_of(sensor.region, mesh.region_names());
  if (sensor.sensor.kind == SensorKind::region) return region_scope(mesh, region, travel_of(sensor));
  if (sensor.region.empty())
    return {-1, surface_of_wall(mesh, number_of(sensor.wall, mesh.wall_names())), travel_of(sensor)};
  const int beyond = number_of(sensor.beyond, mesh.region_names());
  return {-1,
          surface_of(mesh, region, {beyond, beyond < 0 ? number_of(sensor.beyond, mesh.wall_names()) : -1}),
          travel_of(sensor)};
}

void OrdinateSensorTally::start() {
  const std::vector<double> nothing(lights_.paths().bands(), 0);
  sums_.assign(sensors_.size(), {RegionAccount(nothing.size()), {nothing, nothing}});
}

void OrdinateSensorTally::add(const SolveOptions& options, const DirectionSetSolution& swept) {
  if (sets_ == 0) start();
  const TetrahedralMesh& mesh = lights_.problem().mesh();
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    const SensorCase& sensor = sensors_[i];
    if (!reads_ordinates(sensor, lights_.problem().space())) continue;
    if (!has_point(sensor)) {
      sums_[i].account.add(region_account(lights_, options, swept, scope_of(sensor, mesh)), 1);
      continue;
    }
    const OrdinatesAtPoint found =
        ordinates_at_point(mesh, swept, locator_.find(sensor.sensor.position), sensor.sensor.direction);
    add_to(sums_[i].point.irradiance, found.irradiance, 1);
    add_to(sums_[i].point.fluence, found.fluence, 1);
  }
  ++sets_;
}

RegionAccount OrdinateSensorTally::account(std::size_t sensor) const {
  RegionAccount mean(lights_.paths().bands());
  mean.add(sums_.at(sensor).account, 1.0 / sets_);
  return mean;
}

OrdinatesAtPoint OrdinateSensorTally::at_point(std::size_t sensor) const {
  const std::vector<double> nothing(lights_.paths().bands(), 0);
  OrdinatesAtPoint mean{nothing, nothing};
  add_to(mean.irradiance, sums_.at(sensor).point.irradiance, 1.0 / sets_);
  add_to(mean.fluence, sums_.at(sensor).point.fluence, 1.0 / sets_);
  return mean;
}

}  // namespace etendue
