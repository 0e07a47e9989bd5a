// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/expression/formula.h"

namespace etendue {

/// A formula in named variables, parsed once. Constants pi and e are known; `==`, `&&`, `?:` and the usual
/// functions work. Copies are independent; one object must not be evaluated by two threads at a time.
class Expression {
 public:
  /// Throws InputError (without a file; the caller adds it) where the text is not a formula in `variables`.
  Expression(Formula formula, std::vector<std::string> variables);
  ~Expression();
  Expression(const Expression& other);
  Expression& operator=(const Expression& other);
  Expression(Expression&&) noexcept;
  Expression& operator=(Expression&&) noexcept;

  /// `values` in the order of the variables. May be infinite or NaN where the formula is.
  double operator()(std::span<const double> values) const;
  const std::string& text() const { return formula_.text; }
  const Formula& formula() const { return formula_; }
  /// Returns whether the formula uses this variable.
  bool uses(const std::string& variable) const;

 private:
  struct Parser;
  Formula formula_;
  std::vector<std::string> variables_;
  std::unique_ptr<Parser> parser_;
};

}  // namespace etendue
