// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/adjoint/chosen_response.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <span>
#include <system_error>

#include "app/write/result/unit_labels.h"
#include "base/errors.h"

namespace etendue {
namespace {

Fault fault_of(const std::string& name, const std::string& why) {
  return {"", 0, fmt::format("command line: adjoint: --of = {}: {}", name, why)};
}

/// Finds what a name means.
class Chooser {
 public:
  Chooser(const Case& input, const Problem& problem, const CellLocator& locator)
      : input_(input),
        problem_(problem),
        locator_(locator),
        units_(input.units, input.angular_space),
        by_area_("1/" + units_.area),
        by_area_squared_(units_.power + "/" + units_.length + "^4") {}

  /// Throws Fault.
  ChosenResponse choose(const std::string& name) const {
    const std::size_t colon = name.find(':');
    const std::string kind = name.substr(0, colon);
    const std::string rest = colon == std::string::npos ? "" : name.substr(colon + 1);
    if (kind == "probe") return of_probe(name, rest);
    if (kind == "sensor") return of_sensor(name, rest);
    if (kind == "wall")
      return {name,         "power that arrives",
              units_.power, "",
              units_.flux,  ArrivingPower{number_of(name, rest, "wall", problem_.mesh().wall_names())}};
    if (kind == "region")
      return {name,         "power absorbed",
              units_.power, "",
              units_.flux,  AbsorbedPower{number_of(name, rest, "region", problem_.mesh().region_names())}};
    throw fault_of(name, "not known; use probe:NAME, sensor:NAME, wall:NAME or region:NAME");
  }

 private:
  static int number_of(const std::string& name, const std::string& wanted, const std::string& kind,
                       std::span<const std::string> names) {
    const auto found = std::ranges::find(names, wanted);
    if (found == names.end())
      throw fault_of(name, fmt::format("no such {}; use {}", kind, fmt::join(names, ", ")));
    return static_cast<int>(found - names.begin());
  }

  /// The entry of this name in a list of the case.
  template <class Entry>
  static const Entry& entry_of(const std::string& name, const std::string& wanted, const std::string& kind,
                               const std::vector<Entry>& entries) {
    std::vector<std::string> names;
    for (const Entry& entry : entries) names.push_back(entry.name);
    if (names.empty()) throw fault_of(name, fmt::format("the case has no {}", kind));
    return entries[static_cast<std::size_t>(number_of(name, wanted, kind, names))];
  }

  std::vector<CellPoint> cells_at(const std::string& name, const Vec3& point) const {
    std::vector<CellPoint> cells = locator_.find(point);
    if (cells.empty()) throw fault_of(name, "lies outside the mesh");
    return cells;
  }

  ChosenResponse fluence(const std::string& name, const Vec3& point) const {
    return {name, "fluence", units_.flux, by_area_, by_area_squared_, PointFluence{cells_at(name, point)}};
  }
  ChosenResponse irradiance(const std::string& name, const std::vector<Vec3>& points,
                            const Vec3& normal) const {
    MeanIrradiance mean{{}, normal};
    for (const Vec3& point : points) mean.points.push_back(cells_at(name, point));
    return {name,
            points.size() > 1 ? "mean irradiance" : "irradiance",
            units_.flux,
            by_area_,
            by_area_squared_,
            std::move(mean)};
  }

  ChosenResponse of_probe(const std::string& name, const std::string& wanted) const {
    std::string probe_name = wanted;
    std::size_t index = 0;
    // The index of a point may follow where the whole is no probe's name.
    const std::size_t colon = wanted.rfind(':');
    if (colon != std::string::npos && std::ranges::count(input_.probes, wanted, &Probe::name) == 0) {
      const char* const end = wanted.data() + wanted.size();
      const auto read = std::from_chars(wanted.data() + colon + 1, end, index);
      if (read.ec != std::errc{} || read.ptr != end)
        throw fault_of(name, "the index of a point is a whole number; use probe:NAME:INDEX");
      probe_name = wanted.substr(0, colon);
    }
    const Probe& probe = entry_of(name, probe_name, "probe", input_.probes);
    if (index >= probe.points.size() || (probe.points.size() > 1 && probe_name == wanted))
      throw fault_of(name,
                     fmt::format("the probe has {} points; use probe:{}:INDEX with an index from 0 to {}",
                                 probe.points.size(), probe_name, probe.points.size() - 1));
    return probe.normal ? irradiance(name, {probe.points[index]}, *probe.normal)
                        : fluence(name, probe.points[index]);
  }

  ChosenResponse of_sensor(const std::string& name, const std::string& wanted) const {
    const Sensor& sensor = entry_of(name, wanted, "sensor", input_.sensors).sensor;
    switch (sensor.kind) {
      case SensorKind::irradiance:
        return irradiance(name, {sensor.position}, sensor.direction);
      case SensorKind::fluence:
        return fluence(name, sensor.position);
      case SensorKind::grid: {
        std::vector<Vec3> points;
        for (int j = 0; j < sensor.count[1]; ++j)
          for (int i = 0; i < sensor.count[0]; ++i) points.push_back(grid_point(sensor, i, j));
        return irradiance(name, points, sensor.direction);
      }
      default:
        throw fault_of(name,
                       "what this sensor measures has no adjoint in this version; use one of irradiance, "
                       "fluence or a grid");
    }
  }

  const Case& input_;
  const Problem& problem_;
  const CellLocator& locator_;
  UnitLabels units_;
  std::string by_area_;          ///< of a flux by power
  std::string by_area_squared_;  ///< of a flux by area
};

}  // namespace

std::vector<ChosenResponse> choose_responses(const std::vector<std::string>& names, const Case& input,
                                             const Problem& problem, const CellLocator& locator) {
  const Chooser chooser(input, problem, locator);
  std::vector<ChosenResponse> responses;
  std::vector<Fault> faults;
  for (const std::string& name : names) {
    try {
      responses.push_back(chooser.choose(name));
    } catch (const Fault& fault) {
      faults.push_back(fault);
    }
  }
  if (!faults.empty()) throw InputError(std::move(faults));
  return responses;
}

}  // namespace etendue
