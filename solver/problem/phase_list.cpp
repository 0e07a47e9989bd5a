// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/problem/phase_list.h"

#include <algorithm>

namespace etendue {

PhaseList::PhaseList(const Problem& problem) : bands_(static_cast<std::size_t>(problem.band_count())) {
  for (const Medium& medium : problem.media())
    for (const PhaseFunction& phase : medium.phase) {
      if (std::holds_alternative<PhaseIsotropic>(phase)) {
        number_.push_back(-1);
        continue;
      }
      const auto found = std::find(phases_.begin(), phases_.end(), phase);
      number_.push_back(static_cast<int>(found - phases_.begin()));
      if (found == phases_.end()) phases_.push_back(phase);
    }
}

}  // namespace etendue
