// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/expression/dual.h"
#include "base/expression/syntax.h"

namespace etendue {

/// A formula as an Expression takes it, that also knows its exact derivatives. Where it has a kink the
/// derivative is that of one side. May be evaluated by several threads at a time.
class DifferentiableExpression {
 public:
  /// Throws InputError (without a file; the caller adds it) where the text is not a formula in `variables`.
  DifferentiableExpression(std::string text, const std::vector<std::string>& variables);

  const std::string& text() const { return text_; }
  /// `values` in the order of the variables. May be infinite or NaN where the formula is.
  double operator()(std::span<const double> values) const;
  Dual operator()(std::span<const Dual> values) const;

 private:
  std::string text_;
  std::vector<SyntaxNode> nodes_;
};

}  // namespace etendue
