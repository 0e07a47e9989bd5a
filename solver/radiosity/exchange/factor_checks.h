// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/radiosity/exchange/exchange.h"

namespace etendue {

/// What must hold of form factors, and by how much it does not.
struct FactorChecks {
  double row_sum = 0;         ///< largest |sum of F_jk over k - 1| of the factors as they were found
  double row_sum_mean = 0;    ///< root mean square of the same
  double closed_row_sum = 0;  ///< largest one after closing
  int closing_passes = 0;
  double reciprocity = 0;  ///< largest |A_j F_jk - A_k F_kj| / min(A_j, A_k), found both ways; of a sample
  double self = 0;         ///< largest F_jj: patches are flat
  double additivity = 0;   ///< largest |F_jk - sum over parts of k|, unoccluded; of a sample
};

/// Measures, and closes the matrix in between: to this error of the row sums.
FactorChecks check_and_close(Exchange& exchange, double tolerance);

}  // namespace etendue
