// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "base/errors.h"

namespace etendue {

/// When a source emits, in a case with [time].
struct InTime {
  enum class Kind {
    pulse,    ///< at t = 0: powers are energies, power times the unit of time
    step,     ///< from t = 0 on
    formula,  ///< by a factor that is a formula in t
    table     ///< by a factor that is linear between some times, and as at the first and last beyond
  };
  Kind kind = Kind::pulse;
  std::string text = "pulse";   ///< as it is written
  std::vector<double> times;    ///< of a table, rising
  std::vector<double> factors;  ///< at these times
  Origin origin;
};

}  // namespace etendue
