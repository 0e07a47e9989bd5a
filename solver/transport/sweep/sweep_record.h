// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/solution/solution.h"
#include "solver/transport/state/aligned_array.h"

namespace etendue {

/// Results that a sweep records beside the next state when it is asked to.
struct SweepRecord {
  AlignedArray net_flux;  ///< [cell][3][node][stride] [power/length^2]
  AlignedArray exitance;  ///< [boundary face][face node][stride] [power/length^2]
  std::vector<OrdinateRadiance>
      radiance;                         ///< values [cell][node][stride]; ordinates are chosen by the caller
  std::vector<double> meters;           ///< [meter][stride]
  std::vector<double> source_products;  ///< [paired source][stride]
  /// [cell][band] absorbed [power/length^3] where absorption depends on the direction; empty where it nowhere
  /// does.
  std::vector<double> absorbed;
};

}  // namespace etendue
