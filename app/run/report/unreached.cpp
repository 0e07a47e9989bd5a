// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/run/report/unreached.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "solver/solution/node_means.h"

namespace etendue {
namespace {

constexpr double histories_worth = 3;

/// Sets the error of a value that no history reached. Whether it was one.
bool bound(double value, double& error, double most) {
  if (value != 0 || error != 0 || !(most > 0)) return false;
  error = most;
  return true;
}

double surface_of(const TetrahedralMesh& mesh, CellIndex cell) {
  double area = 0;
  for (const std::int32_t face : mesh.faces(cell)) area += mesh.area(FaceIndex(face));
  return area;
}

bool any(const std::vector<std::vector<std::optional<AngularFormula>>>& lists) {
  return std::ranges::any_of(lists, [](const auto& list) {
    return std::ranges::any_of(list, [](const auto& formula) { return formula.has_value(); });
  });
}

/// [power/(length^2 sr)] that nothing in a band can exceed: of walls, and of media whose emission and
/// absorption are in balance. Infinite where that is not known.
double largest_radiance(const Problem& problem, std::size_t band) {
  std::vector<std::vector<std::optional<AngularFormula>>> formulas;
  double largest = 0;
  for (const Wall& wall : problem.walls()) {
    largest = std::max(largest, wall.radiance[band]);
    formulas.push_back(wall.radiance_by_direction);
  }
  for (const Medium& medium : problem.media()) formulas.push_back(medium.emission_by_direction);
  if (any(formulas)) return std::numeric_limits<double>::infinity();
  for (std::int32_t c = 0; c < problem.mesh().cell_count(); ++c) {
    const double emission = problem.emission(CellIndex(c), static_cast<int>(band));
    if (emission > 0)
      largest = std::max(largest, emission / problem.absorption(CellIndex(c), static_cast<int>(band)));
  }
  return largest;
}

/// The bounds of one band of a run.
class Bounds {
 public:
  Bounds(RunResult& result, const CellLocator& locator, std::size_t band)
      : result_(result),
        errors_(*result.errors),
        mesh_(result.problem.mesh()),
        locator_(locator),
        band_(band),
        bands_(static_cast<std::size_t>(result.problem.band_count())),
        power_((result.balances[band].emitted + result.balances[band].inflow) * histories_worth /
               errors_.histories) {}

  void of_cells(const std::vector<double>& means) {
    for (std::int32_t c = 0; c < mesh_.cell_count(); ++c) {
      const CellIndex cell(c);
      const std::size_t i = cell.at() * bands_ + band_;
      if (!bound(means[i], errors_.fluence_mean[i], fluence_in(cell))) continue;
      for (std::size_t node = 0; node < 4; ++node)
        errors_.fluence[(cell.at() * 4 + node) * bands_ + band_] = fluence_in(cell);
    }
  }

  void of_walls() {
    for (std::size_t w = 0; w < result_.walls.size(); ++w) {
      const WallPower& power = result_.walls[w][band_];
      WallPower& error = errors_.walls[w][band_];
      bound(power.incoming, error.incoming, power_);
      bound(power.irradiance_mean, error.irradiance_mean, power_ / power.area);
      bound(power.incoming - power.outgoing, errors_.net[w][band_], power_);
    }
  }

  void of_regions_and_balance() {
    std::vector<char> absorbs(result_.regions.size(), 0);
    for (std::int32_t c = 0; c < mesh_.cell_count(); ++c)
      if (result_.problem.absorption(CellIndex(c), static_cast<int>(band_)) > 0)
        absorbs[static_cast<std::size_t>(mesh_.region(CellIndex(c)))] = 1;
    for (std::size_t r = 0; r < result_.regions.size(); ++r) {
      const RegionPower& power = result_.regions[r][band_];
      RegionPower& error = errors_.regions[r][band_];
      bound(power.fluence_mean, error.fluence_mean, power_ / std::pow(power.volume, 2. / 3));
      if (absorbs[r] != 0) bound(power.absorbed, error.absorbed, power_);
    }
    Balance& error = errors_.balances[band_];
    if (std::ranges::count(absorbs, 1) > 0) bound(result_.balances[band_].absorbed, error.absorbed, power_);
    bound(result_.balances[band_].outflow, error.outflow, power_);
  }

  void of_probes(double walked_back) {
    const double brought = walked_back > 0 ? histories_worth * full_range(result_.problem.space()) *
                                                 largest_radiance(result_.problem, band_) / walked_back
                                           : std::numeric_limits<double>::infinity();
    for (ProbeRow& row : result_.probes) {
      double most = brought;
      if (!std::isfinite(most)) most = fluence_in(locator_.find(row.point).front().cell);
      ProbeValue& error = row.errors->values[band_];
      if (bound(row.values[band_].fluence, error.fluence, most)) {
        ++errors_.unreached_probes;
        for (double& component : error.net_flux) component = most;
      }
      if (row.irradiance && row.errors->irradiance)
        bound((*row.irradiance)[band_], (*row.errors->irradiance)[band_], most);
    }
  }

 private:
  double fluence_in(CellIndex cell) const { return power_ * 4 / surface_of(mesh_, cell); }

  RunResult& result_;
  RunErrors& errors_;
  const TetrahedralMesh& mesh_;
  const CellLocator& locator_;
  std::size_t band_, bands_;
  double power_;  ///< of three histories
};

}  // namespace

void bound_unreached(RunResult& result, const CellLocator& locator, double walked_back) {
  const auto bands = static_cast<std::size_t>(result.problem.band_count());
  const std::vector<double> means = node_means(result.solution.fluence, 4, bands);
  for (std::size_t band = 0; band < bands; ++band) {
    Bounds bounds(result, locator, band);
    bounds.of_cells(means);
    bounds.of_walls();
    bounds.of_regions_and_balance();
    bounds.of_probes(walked_back);
  }
}

}  // namespace etendue
