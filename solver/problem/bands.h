// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace etendue {

/// The spectral bands, solved side by side.
struct Bands {
  std::vector<std::string> names = {"grey"};
  std::vector<double> edges;  ///< [nm], one more than names; may be empty

  int count() const { return static_cast<int>(names.size()); }
};

}  // namespace etendue
