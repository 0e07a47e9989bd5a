// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/command/sensors.h"

#include <fmt/format.h>

#include <algorithm>

#include "solver/sensors/region_account.h"

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

SensorReading read_region(const SensorCase& sensor, const SensorScene& scene) {
  const Problem& problem = scene.lights.problem();
  const auto& names = problem.mesh().region_names();
  const int region = static_cast<int>(std::ranges::find(names, sensor.region) - names.begin());
  std::optional<Cone> travel;
  if (sensor.sensor.half_angle > 0) travel = Cone{-sensor.sensor.direction, sensor.sensor.half_angle};
  const RegionAccount account =
      region_account(scene.lights, scene.directions, scene.options, scene.solution, region, travel);
  using Quantity = RadiometricQuantity;
  const std::vector<double> nothing(account.path.size(), 0);
  const std::vector<double> solid_angle(nothing.size(), account.solid_angle);
  std::vector<double> residual;
  for (std::size_t b = 0; b < nothing.size(); ++b) residual.push_back(account.residual(b));
  SensorReading reading;
  const auto add = [&](Quantity quantity, const std::vector<double>& values) {
    reading.measurements.push_back({quantity, nothing, values, nothing});
  };
  add(Quantity::solid_angle, solid_angle);
  add(Quantity::path, account.path);
  add(Quantity::flowing_in, account.flowing_in);
  add(Quantity::flowing_out, account.flowing_out);
  add(Quantity::emitted, account.emitted);
  add(Quantity::absorbed, account.absorbed);
  add(Quantity::scattered_in, account.scattered_in);
  add(Quantity::scattered_out, account.scattered_out);
  add(Quantity::account_residual, residual);
  return reading;
}

std::string what_a_region_lacks(const Case& input, const LightSetup& lights) {
  if (!lights.empty())
    return "beside lights, whose light is no ordinate's (not in this version); use uncollided = false where "
           "light "
           "comes from";
  if (input.rotations > 1)
    return "in a mean over rotated sets (not in this version); use directions.rotations = 1";
  return "";
}

std::optional<Fault> fault_of(const SensorCase& sensor, const Case& input, const LightSetup& lights,
                              const CellLocator& locator) {
  const TetrahedralMesh& mesh = lights.problem().mesh();
  if (sensor.sensor.kind == SensorKind::intensity) {
    if (placed(sensor, mesh).wall >= 0) return std::nullopt;
    return no_such(sensor, "wall", sensor.wall, mesh.wall_names());
  }
  if (sensor.sensor.kind == SensorKind::region) {
    if (std::ranges::count(mesh.region_names(), sensor.region) == 0)
      return no_such(sensor, "region", sensor.region, mesh.region_names());
    const std::string lacks = what_a_region_lacks(input, lights);
    if (lacks.empty()) return std::nullopt;
    return fault_at(sensor.origin, "", "the account of a region " + lacks);
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

std::vector<SensorRow> read_sensors(const std::vector<SensorCase>& sensors, const SensorScene& scene) {
  std::vector<SensorRow> rows;
  if (!scene.rays) return rows;
  const SensorReader reader(scene.lights, *scene.rays);
  const auto locate = [&](const Vec3& point) { return place_of(point, scene.locator); };
  for (const SensorCase& sensor : sensors)
    if (sensor.sensor.kind == SensorKind::region)
      rows.push_back({sensor, read_region(sensor, scene)});
    else
      rows.push_back({sensor, reader.read(placed(sensor, scene.lights.problem().mesh()), locate,
                                          scene.options.threads)});
  return rows;
}

}  // namespace etendue
