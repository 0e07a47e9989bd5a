// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/ordinates/solution.h"

#include <algorithm>

namespace etendue {

std::vector<FixupTotal> fixup_totals(const Solution& solution) {
  std::vector<FixupTotal> totals;
  for (const OrdinateFixup& fixup : solution.fixups) {
    const auto band = static_cast<std::size_t>(fixup.band);
    if (band >= totals.size()) totals.resize(band + 1);
    FixupTotal& total = totals[band];
    total.cells += fixup.cells;
    total.failed += fixup.failed;
    total.smallest = std::min(total.smallest, fixup.smallest);
    total.moved += fixup.weight * fixup.moved;
  }
  return totals;
}

}  // namespace etendue
