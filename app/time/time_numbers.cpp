// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/time/time_numbers.h"

#include <fmt/format.h>

#include "app/write/result/unit_labels.h"
#include "solver/solution/balance.h"
#include "solver/solution/probe.h"

namespace etendue {
namespace {

std::vector<double> joined(const std::vector<std::vector<double>>& rows) {
  std::vector<double> all;
  for (const std::vector<double>& row : rows) all.insert(all.end(), row.begin(), row.end());
  return all;
}

}  // namespace

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

void TimeNumbers::add_powers(const Problem& problem, const Solution& solution, ByBands& numbers) const {
  const auto bands = static_cast<std::size_t>(problem.band_count());
  const auto add = [&](const auto& of_band) {
    std::vector<double>& row = numbers.emplace_back();
    for (std::size_t band = 0; band < bands; ++band) row.push_back(of_band(band));
  };
  for (const std::vector<WallPower>& wall : wall_powers(problem, solution))
    add([&](std::size_t band) { return wall[band].incoming; });
  for (const std::vector<RegionPower>& region : region_powers(problem, solution)) {
    add([&](std::size_t band) { return region[band].absorbed; });
    add([&](std::size_t band) { return region[band].fluence_mean; });
  }
}

TimeNumbers::ByBands TimeNumbers::by_bands(const Problem& problem, const Solution& solution) const {
  const auto bands = static_cast<std::size_t>(problem.band_count());
  ByBands numbers;
  for (const Place& place : places_) {
    std::vector<double>& row = numbers.emplace_back();
    if (place.meter) {
      const auto own = solution.meters.begin() + static_cast<std::ptrdiff_t>(*place.meter * bands);
      row.assign(own, own + static_cast<std::ptrdiff_t>(bands));
    } else {
      for (const ProbeValue& value : probe(problem, solution, locator_, place.point))
        row.push_back(value.fluence);
    }
  }
  add_powers(problem, solution, numbers);
  return numbers;
}

TimeNumbers::ByBands TimeNumbers::by_bands(const Problem& problem, const UncollidedValues& values) const {
  const auto bands = static_cast<std::size_t>(problem.band_count());
  ByBands numbers;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const auto own = values.places.begin() + static_cast<std::ptrdiff_t>(i * bands);
    numbers.emplace_back(own, own + static_cast<std::ptrdiff_t>(bands));
  }
  Solution unswept;
  unswept.fluence = values.field.fluence;
  unswept.irradiance = values.field.irradiance;
  unswept.exitance.assign(unswept.irradiance.size(), 0);
  unswept.absorbed = values.field.absorbed;
  unswept.half_range.assign(static_cast<std::size_t>(problem.mesh().boundary_face_count()), 0);
  add_powers(problem, unswept, numbers);
  return numbers;
}

std::vector<Vec3> TimeNumbers::fluence_points() const {
  std::vector<Vec3> points;
  for (const Place& place : places_)
    if (!place.meter) points.push_back(place.point);
  return points;
}

std::vector<double> TimeNumbers::values(const Problem& problem, const Solution& solution) const {
  return joined(by_bands(problem, solution));
}

std::vector<TimedPlace> TimeNumbers::timed_places() const {
  std::vector<TimedPlace> places;
  for (const Place& place : places_)
    places.push_back({{locator_.find(place.point).front().cell, place.point},
                      place.meter ? std::optional(meters_[*place.meter].normal) : std::nullopt});
  return places;
}

std::vector<double> TimeNumbers::uncollided(const UncollidedValues& values) const {
  return joined(by_bands(problem_, values));
}

// The bands of a solved problem are [rate][band][real, imaginary part].
std::vector<std::vector<std::complex<double>>> TimeNumbers::of_rates(const ByBands& numbers,
                                                                     std::size_t rates) const {
  const auto bands = static_cast<std::size_t>(problem_.band_count());
  std::vector<std::vector<std::complex<double>>> values(rates);
  for (const std::vector<double>& row : numbers)
    for (std::size_t rate = 0; rate < rates; ++rate)
      for (std::size_t band = 0; band < bands; ++band) {
        const std::size_t real = 2 * (rate * bands + band);
        values[rate].emplace_back(row[real], row[real + 1]);
      }
  return values;
}

std::vector<std::vector<std::complex<double>>> TimeNumbers::read(const SolvedRates& solved) const {
  return of_rates(by_bands(solved.problem, solved.solution), solved.count);
}

std::vector<std::vector<std::complex<double>>> TimeNumbers::uncollided(const SolvedRates& solved) const {
  return of_rates(by_bands(solved.problem, *solved.uncollided), solved.count);
}

}  // namespace etendue
