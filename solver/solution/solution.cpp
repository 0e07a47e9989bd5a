// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/solution/solution.h"

#include <algorithm>

namespace etendue {

std::vector<NegativeCensus> negative_census(const std::vector<double>& fluence, std::size_t bands) {
  std::vector<NegativeCensus> census(bands);
  for (std::size_t i = 0; i < fluence.size(); ++i) {
    if (fluence[i] >= 0) continue;
    NegativeCensus& band = census[i % bands];
    ++band.count;
    band.smallest = std::min(band.smallest, fluence[i]);
  }
  return census;
}

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
