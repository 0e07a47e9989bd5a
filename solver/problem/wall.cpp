// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>

#include "solver/problem/problem.h"

namespace etendue {

bool Wall::is_glossy() const {
  return std::ranges::any_of(glossy, [](const auto& lobe) { return lobe != nullptr; });
}

bool Wall::transmits() const {
  return std::ranges::any_of(transmittance, [](double t) { return t > 0; });
}

}  // namespace etendue
