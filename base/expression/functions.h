// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string_view>

namespace etendue {

/// A function of one argument that formulas know, and its derivative.
struct UnaryFunction {
  std::string_view name;
  double (*value)(double);
  double (*slope)(double);
};

/// Null where there is none of this name.
const UnaryFunction* find_unary_function(std::string_view name);

}  // namespace etendue
