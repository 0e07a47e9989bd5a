// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/values/value_algebra.h"

#include <fmt/format.h>

#include <algorithm>

namespace etendue {

bool is_number(const Value& value) { return std::holds_alternative<double>(value); }

Formula term(const Value& value) {
  if (is_number(value)) return fmt::format("{:.17g}", std::get<double>(value));
  Formula formula = std::get<Formula>(value);
  formula.text = "(" + formula.text + ")";
  return formula;
}

Formula joined(const Value& a, const char* sign, const Value& b) {
  Formula first = term(a), second = term(b);
  first.text += sign + second.text;
  first.functions.merge(second.functions);
  return first;
}

Value product(const Value& a, const Value& b) {
  if (is_number(a) && is_number(b)) return std::get<double>(a) * std::get<double>(b);
  return joined(a, "*", b);
}

Value sum(const Value& a, const Value& b) {
  if (is_number(a) && is_number(b)) return std::get<double>(a) + std::get<double>(b);
  return joined(a, "+", b);
}

Value polynomial(const Value& x, const std::vector<Value>& terms) {
  if (is_number(x) && std::ranges::all_of(terms, is_number)) {
    double sum = 0;
    for (auto term = terms.rbegin(); term != terms.rend(); ++term)
      sum = sum * std::get<double>(x) + std::get<double>(*term);
    return sum;
  }
  Formula formula = term(x);
  for (const Value& value : terms) {
    Formula other = term(value);
    formula.text += "," + other.text;
    formula.functions.merge(other.functions);
  }
  formula.text = "polynomial(" + formula.text + ")";
  return formula;
}

Coefficient coefficient_of(const Value& value) {
  if (const double* number = std::get_if<double>(&value)) return *number;
  return Coefficient(Expression(std::get<Formula>(value), {"x", "y", "z"}));
}

}  // namespace etendue
