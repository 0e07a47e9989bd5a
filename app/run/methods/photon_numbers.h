// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "app/write/result/run_result.h"

namespace etendue {

/// What is measured of a solution in walls, regions and balances, as one list of numbers: so each batch of
/// photons gives the list, and the list of standard errors becomes measures again.
struct MeasuredNumbers {
  std::vector<std::vector<WallPower>> walls;
  std::vector<std::vector<double>> net;  ///< [wall][band] incoming - outgoing
  std::vector<std::vector<RegionPower>> regions;
  std::vector<Balance> balances;

  MeasuredNumbers(const Problem& problem, const Solution& solution);
  std::vector<double> list() const;
  /// Puts other numbers, of the same problem's list, in their places.
  void assign(const std::vector<double>& list);
};

}  // namespace etendue
