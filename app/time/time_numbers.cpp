// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/time/time_numbers.h"

#include <fmt/format.h>

#include "app/write/result/unit_labels.h"
#include "solver/solution/balance.h"
#include "solver/solution/probe.h"

namespace etendue {
TimeNumbers::TimeNumbers(const Case& input, const Problem& problem, const CellLocator& locator)
    : problem_(problem), locator_(locator) {
  for (const Probe& probe : input.probes)
    for (std::size_t i = 0; i < probe.points.size(); ++i) {
      const std::string name = fmt::format("probe {} {}", probe.name, i);
      add_place(name, probe.points[i], std::nullopt);
      if (probe.normal) add_place(name, probe.points[i], probe.normal);
    }
  for (const SensorCase& sensor : input.sensors) add_sensor(sensor);
  const UnitLabels units(input.units, input.angular_space);
  const auto add = [&](const char* quantity, const std::string& name, const std::string& unit) {
    for (const std::string& band : problem.bands().names) quantities_.push_back({quantity, name, band, unit});
  };
  for (const Place& place : places_) add(place.meter ? "irradiance" : "fluence", place.name, units.flux);
  for (const std::string& wall : problem.mesh().wall_names()) add("incoming", "wall " + wall, units.power);
  for (const std::string& region : problem.mesh().region_names()) {
    add("absorbed", "region " + region, units.power);
    add("fluence_mean", "region " + region, units.flux);
  }
}

void TimeNumbers::add_place(const std::string& name, const Vec3& point, const std::optional<Vec3>& normal) {
  Place place{name, point, std::nullopt};
  if (normal) {
    place.meter = meters_.size();
    meters_.push_back({locator_.find(point), *normal});
  }
  places_.push_back(std::move(place));
}

void TimeNumbers::add_sensor(const SensorCase& sensor) {
  const std::string name = "sensor " + sensor.name;
  if (sensor.sensor.kind == SensorKind::irradiance)
    add_place(name, sensor.sensor.position, sensor.sensor.direction);
  else if (sensor.sensor.kind == SensorKind::fluence)
    add_place(name, sensor.sensor.position, std::nullopt);
  else
    left_out_.push_back(sensor.name);
}

std::vector<std::vector<double>> TimeNumbers::by_bands(const Problem& problem,
                                                       const Solution& solution) const {
  const auto bands = static_cast<std::size_t>(problem.band_count());
  std::vector<std::vector<double>> numbers;
  const auto add = [&](const auto& of_band) {
    std::vector<double>& row = numbers.emplace_back();
    for (std::size_t band = 0; band < bands; ++band) row.push_back(of_band(band));
  };
  for (const Place& place : places_) {
    if (place.meter) {
      add([&](std::size_t band) { return solution.meters[*place.meter * bands + band]; });
    } else {
      const std::vector<ProbeValue> values = probe(problem, solution, locator_, place.point);
      add([&](std::size_t band) { return values[band].fluence; });
    }
  }
  for (const std::vector<WallPower>& wall : wall_powers(problem, solution))
    add([&](std::size_t band) { return wall[band].incoming; });
  for (const std::vector<RegionPower>& region : region_powers(problem, solution)) {
    add([&](std::size_t band) { return region[band].absorbed; });
    add([&](std::size_t band) { return region[band].fluence_mean; });
  }
  return numbers;
}

std::vector<Vec3> TimeNumbers::fluence_points() const {
  std::vector<Vec3> points;
  for (const Place& place : places_)
    if (!place.meter) points.push_back(place.point);
  return points;
}

std::vector<double> TimeNumbers::values(const Problem& problem, const Solution& solution) const {
  std::vector<double> values;
  for (const std::vector<double>& row : by_bands(problem, solution))
    values.insert(values.end(), row.begin(), row.end());
  return values;
}

// The bands of a solved problem are [rate][band][real, imaginary part].
std::vector<std::vector<std::complex<double>>> TimeNumbers::read(const SolvedRates& solved) const {
  const auto bands = static_cast<std::size_t>(problem_.band_count());
  std::vector<std::vector<std::complex<double>>> values(solved.count);
  for (const std::vector<double>& row : by_bands(solved.problem, solved.solution))
    for (std::size_t rate = 0; rate < solved.count; ++rate)
      for (std::size_t band = 0; band < bands; ++band) {
        const std::size_t real = 2 * (rate * bands + band);
        values[rate].emplace_back(row[real], row[real + 1]);
      }
  return values;
}

}  // namespace etendue
