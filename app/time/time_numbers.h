// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <complex>
#include <vector>

#include "app/case/case.h"
#include "app/write/result/time_result.h"
#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/problem/problem.h"
#include "solver/solution/solve_options.h"
#include "solver/time/solve_laplace.h"

namespace etendue {

/// The numbers that are read of light in time: of all probes, of sensors of irradiance and fluence, of walls
/// and regions.
class TimeNumbers {
 public:
  /// The arguments must outlive it.
  TimeNumbers(const Case& input, const Problem& problem, const CellLocator& locator);

  const std::vector<TimeQuantity>& quantities() const { return quantities_; }
  /// Those of sensors that are not read [sensor].
  const std::vector<std::string>& left_out() const { return left_out_; }
  /// Where the solutions have to have meters.
  const std::vector<IrradianceMeter>& meters() const { return meters_; }
  /// Where the fluence is read, in the order of its quantities.
  std::vector<Vec3> fluence_points() const;
  /// The numbers of a solution of the problem itself [quantity].
  std::vector<double> values(const Problem& problem, const Solution& solution) const;
  /// The numbers of each solved rate, of its solution alone [rate][quantity].
  std::vector<std::vector<std::complex<double>>> read(const SolvedRates& solved) const;
  /// Where light along rays has to be known.
  std::vector<TimedPlace> timed_places() const;
  /// The numbers of light along rays in the problem's own bands [quantity].
  std::vector<double> uncollided(const UncollidedValues& values) const;
  /// Of each solved rate [rate][quantity].
  std::vector<std::vector<std::complex<double>>> uncollided(const SolvedRates& solved) const;

 private:
  /// A place whose fluence or irradiance is read.
  struct Place {
    std::string name;
    Vec3 point;
    std::optional<std::size_t> meter;  ///< whose irradiance; empty: the fluence
  };

  void add_place(const std::string& name, const Vec3& point, const std::optional<Vec3>& normal);
  void add_sensor(const SensorCase& sensor);
  /// Numbers in each of the bands of a problem [what is read][band].
  using ByBands = std::vector<std::vector<double>>;
  /// The numbers of a solution; the bands of `problem` may be others.
  ByBands by_bands(const Problem& problem, const Solution& solution) const;
  ByBands by_bands(const Problem& problem, const UncollidedValues& values) const;
  void add_powers(const Problem& problem, const Solution& solution, ByBands& numbers) const;
  std::vector<std::vector<std::complex<double>>> of_rates(const ByBands& numbers, std::size_t rates) const;

  const Problem& problem_;
  const CellLocator& locator_;
  std::vector<Place> places_;
  std::vector<IrradianceMeter> meters_;
  std::vector<TimeQuantity> quantities_;
  std::vector<std::string> left_out_;
};

}  // namespace etendue
