// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <span>

#include "solver/materials/media/angular_formula.h"

namespace etendue {

/// Returns whether any of the bands has a formula.
inline bool any_formula(std::span<const std::optional<AngularFormula>> formulas) {
  return std::ranges::any_of(formulas, [](const auto& formula) { return formula.has_value(); });
}

}  // namespace etendue
