// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/readings/sensors.h"

#include <fmt/format.h>

#include <algorithm>

#include "mesh/tetrahedra/bounding_box.h"
#include "solver/observe/sensors/uncollided_account.h"

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

/// The sensor as it is in a mesh.
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

Fault sensor_outside(const SensorCase& sensor, const Vec3& point, const TetrahedralMesh& mesh) {
  const auto [low, high] = bounding_box(mesh.points());
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

/// The part of lights, and the other.
struct AccountParts {
  RegionAccount uncollided, collided;
};

AccountParts accounts_of(const SensorCase& sensor, std::size_t number, const SensorScene& scene,
                         StageCounter& counter) {
  const AccountScope scope = scope_of(sensor, scene.lights.problem().mesh());
  return {uncollided_account(scene.lights, scene.solution, scope, scene.options.threads, &counter),
          scene.ordinates.account(number)};
}

SensorReading read_surface(const SensorCase& sensor, std::size_t number, const SensorScene& scene,
                           StageCounter& counter) {
  const auto [uncollided, collided] = accounts_of(sensor, number, scene, counter);
  const std::vector<double> nothing(collided.path.size(), 0);
  using Quantity = RadiometricQuantity;
  const auto net = [&](const RegionAccount& account) {
    std::vector<double> flow = account.flowing_out;
    for (std::size_t b = 0; b < flow.size(); ++b) flow[b] -= account.flowing_in[b];
    return flow;
  };
  return {{{Quantity::flux_forward, uncollided.flowing_out, collided.flowing_out, nothing},
           {Quantity::flux_backward, uncollided.flowing_in, collided.flowing_in, nothing},
           {Quantity::flux_net, net(uncollided), net(collided), nothing}},
          {}};
}

SensorReading read_point(const SensorCase& sensor, std::size_t number, const SensorScene& scene) {
  const OrdinatesAtPoint found = scene.ordinates.at_point(number);
  const std::vector<double> nothing(found.fluence.size(), 0);
  if (sensor.sensor.kind == SensorKind::fluence)
    return {{{RadiometricQuantity::fluence, nothing, found.fluence, nothing}}, {}};
  return {{{RadiometricQuantity::irradiance, nothing, found.irradiance, nothing}}, {}};
}

SensorReading read_region(const SensorCase& sensor, std::size_t number, const SensorScene& scene,
                          StageCounter& counter) {
  const auto [uncollided, collided] = accounts_of(sensor, number, scene, counter);
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

SensorReading read_ordinates(const SensorCase& sensor, std::size_t number, const SensorScene& scene,
                             StageCounter& counter) {
  if (sensor.sensor.kind == SensorKind::region) return read_region(sensor, number, scene, counter);
  if (sensor.sensor.kind == SensorKind::flux) return read_surface(sensor, number, scene, counter);
  return read_point(sensor, number, scene);
}

/// Rays, cells and faces that are evaluated for a sensor. `reader` is there where rays are.
std::size_t parts_of(const SensorCase& sensor, const SensorScene& scene, const SensorReader* reader,
                     const SensorReader::Locate& locate) {
  const Problem& problem = scene.lights.problem();
  if (!reads_ordinates(sensor, problem.space()))
    return reader->rays_of(placed(sensor, problem.mesh()), locate);
  const bool has_account = sensor.sensor.kind == SensorKind::region || sensor.sensor.kind == SensorKind::flux;
  if (scene.lights.empty() || !has_account) return 0;
  return account_parts(problem.mesh(), scope_of(sensor, problem.mesh()));
}

std::optional<Fault> fault_of_names(const SensorCase& sensor, const TetrahedralMesh& mesh) {
  const auto& regions = mesh.region_names();
  const auto& walls = mesh.wall_names();
  const auto is_among = [](const std::string& name, const std::vector<std::string>& names) {
    return name.empty() || std::ranges::count(names, name) > 0;
  };
  if (!is_among(sensor.wall, walls)) return no_such(sensor, "wall", sensor.wall, walls);
  if (!is_among(sensor.region, regions)) return no_such(sensor, "region", sensor.region, regions);
  if (!is_among(sensor.beyond, regions) && !is_among(sensor.beyond, walls)) {
    std::vector<std::string> all = regions;
    all.insert(all.end(), walls.begin(), walls.end());
    return no_such(sensor, "region or wall", sensor.beyond, all);
  }
  if (!sensor.beyond.empty() && scope_of(sensor, mesh).surface.empty())
    return fault_at(
        sensor.origin, sensor.beyond,
        fmt::format("the sensor \"{}\" measures between {} and this, which do not touch; use what "
                    "lies beside the region",
                    sensor.name, sensor.region));
  return std::nullopt;
}

std::optional<Fault> fault_of_walls(const SensorCase& sensor, const Problem& problem) {
  for (const Wall& wall : problem.walls())
    if (wall.is_glossy() || (wall.transmits() && !sensor.region.empty()))
      return fault_at(
          sensor.origin, "",
          fmt::format("an account of ordinates in a case where a wall ({}) is glossy or lets light "
                      "through (not in this version); remove one of the two",
                      wall.name));
  return std::nullopt;
}

std::optional<Fault> fault_of(const SensorCase& sensor, const CellLocator& locator,
                              const TetrahedralMesh& mesh) {
  if (auto fault = fault_of_names(sensor, mesh)) return fault;
  if (!sensor.wall.empty() || !sensor.region.empty()) return std::nullopt;
  const std::vector<Vec3> points = points_of(sensor.sensor);
  if (std::ranges::any_of(points, [&](const Vec3& point) { return !locator.find(point).empty(); }))
    return std::nullopt;
  return sensor_outside(sensor, points.front(), mesh);
}

}  // namespace

void check_sensors(const std::vector<SensorCase>& sensors, const CellLocator& locator,
                   const Problem& problem) {
  std::vector<Fault> faults;
  for (const SensorCase& sensor : sensors) {
    if (auto fault = fault_of(sensor, locator, problem.mesh())) faults.push_back(*std::move(fault));
    if (reads_ordinates(sensor, problem.space()))
      if (auto fault = fault_of_walls(sensor, problem)) faults.push_back(*std::move(fault));
  }
  if (!faults.empty()) throw InputError(std::move(faults));
}

std::vector<SensorRow> read_sensors(const std::vector<SensorCase>& sensors, const SensorScene& scene,
                                    const StageObserver& observer) {
  const Problem& problem = scene.lights.problem();
  std::optional<SensorReader> reader;
  if (scene.rays) reader.emplace(scene.lights, *scene.rays);
  const auto locate = [&](const Vec3& point) { return place_of(point, scene.locator); };
  std::size_t parts = 0;
  for (const SensorCase& sensor : sensors)
    parts += parts_of(sensor, scene, reader ? &*reader : nullptr, locate);
  StageCounter counter(parts, observer);
  std::vector<SensorRow> rows;
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    const SensorCase& sensor = sensors[i];
    std::optional<SensorReading> reading;
    if (reads_ordinates(sensor, problem.space()))
      reading = read_ordinates(sensor, i, scene, counter);
    else
      reading = reader.value().read(placed(sensor, problem.mesh()), locate, scene.options.threads, counter);
    if (counter.stopped()) return rows;
    rows.push_back({sensor, *std::move(reading)});
  }
  return rows;
}

}  // namespace etendue
