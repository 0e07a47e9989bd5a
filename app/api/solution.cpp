// SPDX-License-Identifier: AGPL-3.0-or-later
#include <etendue/solution.h>
#include <fmt/format.h>

#include <limits>

#include "app/api/solution_impl.h"
#include "app/api/translated.h"
#include "app/case/temperatures.h"
#include "app/readings/probes.h"
#include "app/write/csv/sensor_rows.h"
#include "app/write/result/heat_rows.h"
#include "app/write/result/temperature_fields.h"
#include "app/write/results.h"
#include "app/write/vtk/vtk_files.h"

namespace etendue::v0 {
namespace {

/// The points of a list that lie in the mesh, and which these are.
struct PointsInside {
  std::vector<std::size_t> numbers;
  etendue::Probe probe;
};

PointsInside inside(std::span<const double> points, const CellLocator& locator) {
  PointsInside found;
  for (std::size_t i = 0; i < points.size() / 3; ++i) {
    const Vec3 point(points[3 * i], points[3 * i + 1], points[3 * i + 2]);
    if (!point.allFinite() || locator.find(point).empty()) continue;
    found.numbers.push_back(i);
    found.probe.points.push_back(point);
  }
  return found;
}

/// By ordinates as read_probes() has them, else the field of the cells.
std::vector<std::vector<ProbeValue>> values_at(const SolvedCase& solved, const etendue::Probe& probe) {
  std::vector<std::vector<ProbeValue>> values;
  if (solved.ordinates) {
    for (ProbeRow& row :
         read_probes({probe}, solved.ordinates->lights, solved.solution, solved.locator, solved.threads()))
      values.push_back(std::move(row.values));
    return values;
  }
  for (const Vec3& point : probe.points)
    values.push_back(etendue::probe(solved.problem, solved.solution, solved.locator, point));
  return values;
}

}  // namespace

Solution::Solution(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}
Solution::~Solution() = default;
Solution::Solution(const Solution&) = default;
Solution::Solution(Solution&&) noexcept = default;
Solution& Solution::operator=(const Solution&) = default;
Solution& Solution::operator=(Solution&&) noexcept = default;

const Mesh& Solution::mesh() const { return impl_->mesh; }
const std::vector<std::string>& Solution::bands() const { return impl_->solved->problem.bands().names; }
const std::string& Solution::method() const { return impl_->solved->solution.method; }
bool Solution::converged() const {
  const std::optional<TimeResult>& in_time = impl_->solved->in_time;
  return impl_->solved->solution.converged() && (!in_time || in_time->converged);
}
const std::vector<std::string>& Solution::notes() const { return impl_->solved->solution.notes; }

std::vector<BandIteration> Solution::iterations() const {
  std::vector<BandIteration> list;
  const auto& bands = impl_->solved->solution.convergence;
  for (std::size_t b = 0; b < bands.size(); ++b)
    list.push_back({this->bands()[b], bands[b].sweeps, bands[b].residual, bands[b].converged});
  return list;
}

std::span<const double> Solution::fluence() const { return impl_->solved->solution.fluence; }
std::span<const double> Solution::net_flux() const { return impl_->solved->solution.net_flux; }
std::span<const double> Solution::irradiance() const { return impl_->solved->solution.irradiance; }
std::span<const double> Solution::exitance() const { return impl_->solved->solution.exitance; }

std::vector<double> Solution::fluence_at(std::span<const double> points) const {
  return translated([&] {
    if (points.size() % 3 != 0)
      throw etendue::InputError(
          fmt::format("points: {} coordinates are no points; give x, y and z of each", points.size()));
    const std::size_t bands = this->bands().size();
    std::vector<double> fluence(points.size() / 3 * bands, std::numeric_limits<double>::quiet_NaN());
    const PointsInside found = inside(points, impl_->solved->locator);
    const auto values = values_at(*impl_->solved, found.probe);
    for (std::size_t i = 0; i < values.size(); ++i)
      for (std::size_t b = 0; b < bands; ++b) fluence[found.numbers[i] * bands + b] = values[i][b].fluence;
    return fluence;
  });
}

std::vector<BandBalance> Solution::balances() const {
  std::vector<BandBalance> list;
  for (const Balance& balance : impl_->result().balances)
    list.push_back({bands()[list.size()], balance.emitted, balance.inflow, balance.absorbed, balance.outflow,
                    balance.residual});
  return list;
}

std::vector<WallTotals> Solution::walls() const {
  std::vector<WallTotals> list;
  const RunResult& result = impl_->result();
  for (std::size_t w = 0; w < result.walls.size(); ++w)
    for (std::size_t b = 0; b < result.walls[w].size(); ++b) {
      const WallPower& power = result.walls[w][b];
      list.push_back({result.problem.walls()[w].name, bands()[b], power.area, power.irradiance_mean,
                      power.incoming, power.outgoing});
    }
  return list;
}

std::vector<RegionTotals> Solution::regions() const {
  std::vector<RegionTotals> list;
  const RunResult& result = impl_->result();
  for (std::size_t r = 0; r < result.regions.size(); ++r)
    for (std::size_t b = 0; b < result.regions[r].size(); ++b) {
      const RegionPower& power = result.regions[r][b];
      list.push_back({result.problem.media()[r].name, bands()[b], power.volume, power.fluence_mean,
                      power.absorbed, power.emitted});
    }
  return list;
}

std::vector<HeatTotals> Solution::heat() const {
  std::vector<HeatTotals> list;
  const RunResult& result = impl_->result();
  if (!has_temperatures(result.input)) return list;
  for (const HeatRow& row : heat_rows(result))
    list.push_back({row.is_wall ? "wall" : "region", row.name, row.extent, row.emitted, row.absorbed, row.net,
                    row.conducted, row.convected, row.temperature});
  return list;
}

std::vector<double> Solution::cell_temperature() const {
  const RunResult& result = impl_->result();
  return has_temperatures(result.input) ? cell_temperatures(result) : std::vector<double>();
}

std::vector<double> Solution::wall_temperature() const {
  const RunResult& result = impl_->result();
  return has_temperatures(result.input) ? vertex_temperatures_of_walls(result) : std::vector<double>();
}

std::vector<ProbeReading> Solution::probes() const {
  std::vector<ProbeReading> list;
  for (const ProbeRow& row : impl_->result().probes)
    for (std::size_t b = 0; b < row.values.size(); ++b) {
      ProbeReading& reading = list.emplace_back();
      reading.probe = row.name;
      reading.index = row.index;
      reading.point = {row.point.x(), row.point.y(), row.point.z()};
      reading.band = bands()[b];
      reading.fluence = row.values[b].fluence;
      reading.net_flux = row.values[b].net_flux;
      if (row.irradiance) reading.irradiance = (*row.irradiance)[b];
    }
  return list;
}

std::vector<SensorReading> Solution::sensors() const {
  std::vector<SensorReading> list;
  for (const SensorTableRow& row : sensor_rows(impl_->result()))
    list.push_back(
        {row.sensor, row.band, row.quantity, row.uncollided, row.collided, row.value(), row.error, row.unit});
  return list;
}

Image Solution::render(const std::string& camera, const std::function<bool()>& stop) const {
  return translated([&] { return take_image(*impl_, camera, stop); });
}

void Solution::write_fields(const std::filesystem::path& file) const {
  translated([&] { etendue::write_fields(impl_->result(), file, file); });
}

void Solution::write(const std::filesystem::path& directory) const {
  translated([&] {
    const std::scoped_lock alone(impl_->changing);
    impl_->solved->input.output.directory = std::filesystem::absolute(directory);
    write_results(impl_->result());
  });
}

}  // namespace etendue::v0
