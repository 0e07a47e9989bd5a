// SPDX-License-Identifier: AGPL-3.0-or-later
#include <array>
#include <cmath>
#include <cstdlib>

#include "base/errors.h"
#include "base/expression/differentiable.h"
#include "base/expression/expression.h"

/// A formula is evaluated, twice to the same value, or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const std::vector<std::string> variables = {"x", "y", "z"};
  const std::array<double, 3> point = {0.25, -0.5, 0.75};
  try {
    const etendue::Expression formula(text, variables);
    const double value = formula(point);
    if (!(formula(point) == value) && !std::isnan(value)) std::abort();
  } catch (const etendue::InputError&) {
  }
  try {
    const etendue::DifferentiableExpression formula(text, variables);
    const double value = formula(point);
    if (!(formula(point) == value) && !std::isnan(value)) std::abort();
  } catch (const etendue::InputError&) {
  }
  return 0;
}
