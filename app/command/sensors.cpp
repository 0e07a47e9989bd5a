// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/command/sensors.h"

#include <fmt/format.h>

#include <algorithm>

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

Fault no_such_wall(const SensorCase& sensor, const TetrahedralMesh& mesh) {
  std::string names;
  for (const std::string& name : mesh.wall_names()) names += (names.empty() ? "" : ", ") + name;
  return fault_at(
      sensor.origin, sensor.wall,
      fmt::format("the sensor \"{}\" names a wall that the mesh does not have; use {}", sensor.name, names));
}

std::optional<PointInCell> place_of(const Vec3& point, const CellLocator& locator) {
  const std::vector<CellPoint> cells = locator.find(point);
  if (cells.empty()) return std::nullopt;
  return PointInCell{cells.front().cell, point};
}

}  // namespace

void check_sensors(const std::vector<SensorCase>& sensors, const TetrahedralMesh& mesh,
                   const CellLocator& locator) {
  Vec3 low = mesh.points().front(), high = low;
  for (const Vec3& p : mesh.points()) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  std::vector<Fault> faults;
  for (const SensorCase& sensor : sensors) {
    if (sensor.sensor.kind == SensorKind::intensity) {
      if (placed(sensor, mesh).wall < 0) faults.push_back(no_such_wall(sensor, mesh));
      continue;
    }
    const std::vector<Vec3> points = points_of(sensor.sensor);
    if (std::ranges::any_of(points, [&](const Vec3& point) { return !locator.find(point).empty(); }))
      continue;
    const Vec3& point = points.front();
    faults.push_back(fault_at(
        sensor.origin, fmt::format("[{}, {}, {}]", point.x(), point.y(), point.z()),
        fmt::format(
            "the sensor \"{}\" lies outside the mesh (which reaches from [{}, {}, {}] to [{}, {}, {}]); move "
            "it into a region",
            sensor.name, low.x(), low.y(), low.z(), high.x(), high.y(), high.z())));
  }
  if (!faults.empty()) throw InputError(std::move(faults));
}

std::vector<SensorRow> read_sensors(const std::vector<SensorCase>& sensors, const LightSetup& lights,
                                    const std::optional<RayRadiance>& scene, const CellLocator& locator,
                                    int threads) {
  std::vector<SensorRow> rows;
  if (!scene) return rows;
  const SensorReader reader(lights, *scene);
  for (const SensorCase& sensor : sensors)
    rows.push_back({sensor, reader.read(
                                placed(sensor, lights.problem().mesh()),
                                [&](const Vec3& point) { return place_of(point, locator); }, threads)});
  return rows;
}

}  // namespace etendue
