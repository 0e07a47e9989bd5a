// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/problem/problem.h"

namespace etendue {

/// The phase functions of a problem that are not isotropic, each once, and which of them each region and band
/// has.
class PhaseList {
 public:
  explicit PhaseList(const Problem& problem);

  const std::vector<PhaseFunction>& phases() const { return phases_; }
  /// Its number in phases(); -1 where scattering is isotropic.
  int of(int region, std::size_t band) const {
    return number_[static_cast<std::size_t>(region) * bands_ + band];
  }

 private:
  std::size_t bands_;
  std::vector<PhaseFunction> phases_;
  std::vector<int> number_;  ///< [region][band]
};

}  // namespace etendue
