// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "app/write/result/run_result.h"
#include "mesh/tetrahedra/search/cell_locator.h"

namespace etendue {

/// Gives numbers of a run by photons that no history reached, 0 with a standard error of 0, an upper bound as
/// their error: three histories' worth. Where none of N histories brings anything, fewer than three of N do,
/// with a confidence of 95 % (rule of three). A history carries power / N through a mean chord 4 V / S of a
/// cell; one that is walked back from a probe brings at most the full range of directions times the largest
/// radiance. Numbers that are 0 by nature, as what a region absorbs that cannot absorb, stay as they are.
/// `walked_back` is the number of histories of each probe; 0 where probes read the field of the cells.
void bound_unreached(RunResult& result, const CellLocator& locator, double walked_back);

}  // namespace etendue
