// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/expression/functions.h"

namespace etendue {

enum class Operation {
  constant,
  variable,
  add,
  subtract,
  multiply,
  divide,
  power,
  negate,
  both,    ///< &&
  either,  ///< ||
  less,
  less_or_equal,
  greater,
  greater_or_equal,
  equal,
  unequal,
  choose,  ///< ?:
  unary,   ///< a function of one argument
  atan2,
  sum,
  average,
  smallest,
  largest,
  polynomial  ///< of the first operand, constant term first
};

/// One operation of a formula; its operands stand before it.
struct SyntaxNode {
  Operation operation = Operation::constant;
  double constant = 0;
  std::size_t variable = 0;
  const UnaryFunction* function = nullptr;
  std::vector<std::size_t> operands = {};
};

/// A formula as a tree, the root last. The grammar is muParser's; throws InputError (without a file) at what
/// is not in it.
std::vector<SyntaxNode> parse_formula(const std::string& text, const std::vector<std::string>& variables);

}  // namespace etendue
