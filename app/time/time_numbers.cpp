// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/time/time_numbers.h"

#include <fmt/format.h>

#include "app/write/result/unit_labels.h"
#include "solver/solution/balance.h"
#include "solver/solution/probe.h"

namespace etendue {
namespace {

/// Numbers of a problem whose bands are [rate][band][part], taken apart.
class Parts {
 public:
  Parts(std::size_t rates, std::size_t bands) : bands_(bands), values_(rates) {}

  /// Adds a quantity whose value in each of the problem's bands is of(band).
  template <class Of>
  void add(const Of& of) {
    for (std::size_t rate = 0; rate < values_.size(); ++rate)
      for (std::size_t band = 0; band < bands_; ++band) {
        const std::size_t real = 2 * (rate * bands_ + band);
        values_[rate].emplace_back(of(real), of(real + 1));
      }
  }
  std::vector<std::vector<std::complex<double>>> take() && { return std::move(values_); }

 private:
  std::size_t bands_;
  std::vector<std::vector<std::complex<double>>> values_;
};

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

std::vector<std::vector<std::complex<double>>> TimeNumbers::read(const SolvedRates& solved) const {
  const auto bands = static_cast<std::size_t>(solved.problem.band_count());
  Parts parts(solved.count, static_cast<std::size_t>(problem_.band_count()));
  for (const Place& place : places_) {
    if (place.meter) {
      parts.add([&](std::size_t band) { return solved.solution.meters[*place.meter * bands + band]; });
    } else {
      const std::vector<ProbeValue> values = probe(solved.problem, solved.solution, locator_, place.point);
      parts.add([&](std::size_t band) { return values[band].fluence; });
    }
  }
  for (const std::vector<WallPower>& wall : wall_powers(solved.problem, solved.solution))
    parts.add([&](std::size_t band) { return wall[band].incoming; });
  for (const std::vector<RegionPower>& region : region_powers(solved.problem, solved.solution)) {
    parts.add([&](std::size_t band) { return region[band].absorbed; });
    parts.add([&](std::size_t band) { return region[band].fluence_mean; });
  }
  return std::move(parts).take();
}

}  // namespace etendue
