// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/command/sensors.h"

#include <fmt/format.h>

#include <algorithm>

#include "solver/sensors/uncollided_account.h"

namespace etendue {
namespace {

/// Points of which one at least must lie in the mesh.
std::vector<Vec3> points_of(const Sensor& sensor) {
  if (sensor.kind == SensorKind::flux) return sensor.polygon;
  if (sensor.kind != SensorKind::grid) return {sensor.position};
  std::vector<Vec3> points;
  for (int j = 0; j < sensor.count[1]; ++j)
    for (int i = 0; i < sensor.count[0]; ++i) points.push_back(grid_point(sensor, i, j));
  return points;
}

/// The sensor as it stands in a mesh.
Sensor placed(const SensorCase& sensor, const TetrahedralMesh& mesh) {
  Sensor result = sensor.sensor;
  const auto wall = std::ranges::find(mesh.wall_names(), sensor.wall);
  if (wall != mesh.wall_names().end()) result.wall = static_cast<int>(wall - mesh.wall_names().begin());
  return result;
}

Fault no_such(const SensorCase& sensor, const std::string& what, const std::string& name,
              const std::vector<std::string>& names) {
  return fault_at(sensor.origin, name,
                  fmt::format("the sensor \"{}\" names a {} that the mesh does not have; use {}", sensor.name,
                              what, fmt::join(names, ", ")));
}

Fault outside(const SensorCase& sensor, const Vec3& point, const TetrahedralMesh& mesh) {
  Vec3 low = mesh.points().front(), high = low;
  for (const Vec3& p : mesh.points()) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return fault_at(
      sensor.origin, fmt::format("[{}, {}, {}]", point.x(), point.y(), point.z()),
      fmt::format(
          "the sensor \"{}\" lies outside the mesh (which reaches from [{}, {}, {}] to [{}, {}, {}]); move "
          "it into a region",
          sensor.name, low.x(), low.y(), low.z(), high.x(), high.y(), high.z()));
}

std::optional<PointInCell> place_of(const Vec3& point, const CellLocator& locator) {
  const std::vector<CellPoint> cells = locator.find(point);
  if (cells.empty()) return std::nullopt;
  return PointInCell{cells.front().cell, point};
}

int region_of(const SensorCase& sensor, const TetrahedralMesh& mesh) {
  const auto& names = mesh.region_names();
  return static_cast<int>(std::ranges::find(names, sensor.region) - names.begin());
}

/// Directions of travel that count.
std::optional<Cone> travel_of(const SensorCase& sensor) {
  if (sensor.sensor.half_angle > 0) return Cone{-sensor.sensor.direction, sensor.sensor.half_angle};
  return std::nullopt;
}

SensorReading read_region(const SensorCase& sensor, std::size_t number, const SensorScene& scene) {
  const RegionAccount uncollided =
      uncollided_account(scene.lights, scene.solution, region_of(sensor, scene.lights.problem().mesh()),
                         travel_of(sensor), scene.options.threads);
  const RegionAccount collided = scene.accounts.collided(number);
  using Quantity = RadiometricQuantity;
  const std::size_t bands = collided.path.size();
  const std::vector<double> nothing(bands, 0);
  SensorReading reading;
  const auto add = [&](Quantity quantity, const std::vector<double>& first, const std::vector<double>& rest) {
    reading.measurements.push_back({quantity, first, rest, nothing});
  };
  add(Quantity::solid_angle, nothing, std::vector<double>(bands, collided.solid_angle));
  add(Quantity::path, uncollided.path, collided.path);
  add(Quantity::flowing_in, uncollided.flowing_in, collided.flowing_in);
  add(Quantity::flowing_out, uncollided.flowing_out, collided.flowing_out);
  add(Quantity::emitted, uncollided.emitted, collided.emitted);
  add(Quantity::absorbed, uncollided.absorbed, collided.absorbed);
  add(Quantity::scattered_in, uncollided.scattered_in, collided.scattered_in);
  add(Quantity::scattered_out, uncollided.scattered_out, collided.scattered_out);
  std::vector<double> missing, missing_rest;
  for (std::size_t b = 0; b < bands; ++b) {
    const double all = uncollided.coming_in(b) + collided.coming_in(b);
    missing.push_back(all > 0 ? uncollided.missing(b) / all : 0);
    missing_rest.push_back(all > 0 ? collided.missing(b) / all : 0);
  }
  add(Quantity::account_residual, missing, missing_rest);
  return reading;
}

std::optional<Fault> fault_of(const SensorCase& sensor, const Case& input, const LightSetup& lights,
                              const CellLocator& locator) {
  const TetrahedralMesh& mesh = lights.problem().mesh();
  if (!sensor.wall.empty()) {
    if (placed(sensor, mesh).wall >= 0) return std::nullopt;
    return no_such(sensor, "wall", sensor.wall, mesh.wall_names());
  }
  if (sensor.sensor.kind == SensorKind::region) {
    if (std::ranges::count(mesh.region_names(), sensor.region) == 0)
      return no_such(sensor, "region", sensor.region, mesh.region_names());
    if (!input.first_collided) return std::nullopt;
    return fault_at(sensor.origin, "",
                    "the account of a region in a run with directions.first_collided, whose first collisions "
                    "are no ordinate's (not in this version); remove one of the two");
  }
  const std::vector<Vec3> points = points_of(sensor.sensor);
  if (std::ranges::any_of(points, [&](const Vec3& point) { return !locator.find(point).empty(); }))
    return std::nullopt;
  return outside(sensor, points.front(), mesh);
}

}  // namespace

void check_sensors(const Case& input, const LightSetup& lights, const CellLocator& locator) {
  std::vector<Fault> faults;
  for (const SensorCase& sensor : input.sensors)
    if (auto fault = fault_of(sensor, input, lights, locator)) faults.push_back(*std::move(fault));
  if (!faults.empty()) throw InputError(std::move(faults));
}

bool need_all_ordinates(const std::vector<SensorCase>& sensors) {
  return std::ranges::any_of(
      sensors, [](const SensorCase& sensor) { return sensor.sensor.kind == SensorKind::region; });
}

void AccountBook::add(const DirectionSet& directions, const SolveOptions& options, const Solution& solution,
                      const AngularInput* input) {
  sums_.resize(sensors_.size(), RegionAccount(lights_.paths().bands()));
  for (std::size_t i = 0; i < sensors_.size(); ++i)
    if (sensors_[i].sensor.kind == SensorKind::region)
      sums_[i].add(region_account(lights_, directions, options, solution, input,
                                  region_of(sensors_[i], lights_.problem().mesh()), travel_of(sensors_[i])),
                   1);
  ++sets_;
}

RegionAccount AccountBook::collided(std::size_t sensor) const {
  RegionAccount mean(lights_.paths().bands());
  mean.add(sums_.at(sensor), 1.0 / sets_);
  return mean;
}

std::vector<SensorRow> read_sensors(const std::vector<SensorCase>& sensors, const SensorScene& scene) {
  std::vector<SensorRow> rows;
  if (!scene.rays) return rows;
  const SensorReader reader(scene.lights, *scene.rays);
  const auto locate = [&](const Vec3& point) { return place_of(point, scene.locator); };
  for (const SensorCase& sensor : sensors)
    if (sensor.sensor.kind == SensorKind::region)
      rows.push_back({sensor, read_region(sensor, rows.size(), scene)});
    else
      rows.push_back({sensor, reader.read(placed(sensor, scene.lights.problem().mesh()), locate,
                                          scene.options.threads)});
  return rows;
}

}  // namespace etendue
