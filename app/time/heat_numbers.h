// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/write/result/run_result.h"
#include "mesh/tetrahedra/search/cell_locator.h"

namespace etendue {

/// The numbers that are read at each step of temperatures that change with time: of probes, walls and
/// regions.
class HeatNumbers {
 public:
  /// The arguments must outlive it.
  HeatNumbers(const Case& input, const Problem& problem, const CellLocator& locator);

  const std::vector<TimeQuantity>& quantities() const { return quantities_; }
  /// [quantity] Of a solution with the emission of its temperatures in the problem, and the heat that has
  /// been stored since t = 0 [J].
  std::vector<double> values(const Solution& solution, const HeatSolution& heat, double stored) const;

 private:
  const Case& input_;
  const Problem& problem_;
  std::vector<CellPoint> places_;  ///< of probes in media whose temperature follows
  std::vector<TimeQuantity> quantities_;
};

}  // namespace etendue
