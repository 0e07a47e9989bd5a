// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/expression/differentiable.h"

#include <cmath>

#include "base/expression/expression.h"

namespace etendue {
namespace {

// The arithmetic of values alone, and of values with gradients.
double value_of(double a) { return a; }
double value_of(const Dual& a) { return a.value; }
double add(double a, double b) { return a + b; }
Dual add(const Dual& a, const Dual& b) { return {a.value + b.value, a.gradient + b.gradient}; }
double scale(double a, double factor) { return a * factor; }
Dual scale(const Dual& a, double factor) { return {a.value * factor, a.gradient * factor}; }
double multiply(double a, double b) { return a * b; }
Dual multiply(const Dual& a, const Dual& b) {
  return {a.value * b.value, a.value * b.gradient + b.value * a.gradient};
}
double divide(double a, double b) { return a / b; }
Dual divide(const Dual& a, const Dual& b) {
  const double quotient = a.value / b.value;
  return {quotient, (a.gradient - quotient * b.gradient) / b.value};
}
double power(double a, double b) { return std::pow(a, b); }
Dual power(const Dual& a, const Dual& b) {
  const double value = std::pow(a.value, b.value);
  const double slope = b.value == 0 ? 0 : b.value * std::pow(a.value, b.value - 1);
  Dual result = chained(a, value, slope);
  // A logarithm only where the exponent varies: a constant power of a negative number has a derivative.
  if (!b.gradient.isZero(0)) result.gradient += value * std::log(a.value) * b.gradient;
  return result;
}
double apply(const UnaryFunction& function, double a) { return function.value(a); }
Dual apply(const UnaryFunction& function, const Dual& a) {
  return chained(a, function.value(a.value), function.slope(a.value));
}
double angle_of(double y, double x) { return std::atan2(y, x); }
Dual angle_of(const Dual& y, const Dual& x) {
  const double square = x.value * x.value + y.value * y.value;
  return {std::atan2(y.value, x.value), (x.value * y.gradient - y.value * x.gradient) / square};
}

template <class Number>
class Evaluation {
 public:
  Evaluation(const std::vector<SyntaxNode>& nodes, std::span<const Number> values)
      : nodes_(nodes), values_(values) {}

  Number of(std::size_t at) const {
    const SyntaxNode& node = nodes_[at];
    switch (node.operation) {
      case Operation::constant:
        return Number{node.constant};
      case Operation::variable:
        return values_[node.variable];
      case Operation::add:
        return add(operand(node, 0), operand(node, 1));
      case Operation::subtract:
        return add(operand(node, 0), scale(operand(node, 1), -1));
      case Operation::multiply:
        return multiply(operand(node, 0), operand(node, 1));
      case Operation::divide:
        return divide(operand(node, 0), operand(node, 1));
      case Operation::power:
        return power(operand(node, 0), operand(node, 1));
      case Operation::negate:
        return scale(operand(node, 0), -1);
      case Operation::choose:
        return operand(node, value(node, 0) != 0 ? 1 : 2);
      case Operation::unary:
        return apply(*node.function, operand(node, 0));
      case Operation::atan2:
        return angle_of(operand(node, 0), operand(node, 1));
      case Operation::sum:
        return sum(node);
      case Operation::average:
        return scale(sum(node), 1 / static_cast<double>(node.operands.size()));
      case Operation::smallest:
        return extreme(node, [](double a, double b) { return a < b; });
      case Operation::largest:
        return extreme(node, [](double a, double b) { return a > b; });
      case Operation::polynomial:
        return polynomial(node);
      default:
        return Number{comparison(node) ? 1.0 : 0.0};
    }
  }

 private:
  Number operand(const SyntaxNode& node, std::size_t i) const { return of(node.operands[i]); }
  double value(const SyntaxNode& node, std::size_t i) const { return value_of(operand(node, i)); }

  bool comparison(const SyntaxNode& node) const {
    const double a = value(node, 0), b = value(node, 1);
    switch (node.operation) {
      case Operation::both:
        return a != 0 && b != 0;
      case Operation::either:
        return a != 0 || b != 0;
      case Operation::less:
        return a < b;
      case Operation::less_or_equal:
        return a <= b;
      case Operation::greater:
        return a > b;
      case Operation::greater_or_equal:
        return a >= b;
      case Operation::equal:
        return a == b;
      default:
        return a != b;
    }
  }

  Number sum(const SyntaxNode& node) const {
    Number total = operand(node, 0);
    for (std::size_t i = 1; i < node.operands.size(); ++i) total = add(total, operand(node, i));
    return total;
  }

  /// By Horner's rule.
  Number polynomial(const SyntaxNode& node) const {
    const Number x = operand(node, 0);
    Number result = operand(node, node.operands.size() - 1);
    for (std::size_t i = node.operands.size() - 1; i-- > 1;)
      result = add(multiply(result, x), operand(node, i));
    return result;
  }

  template <class Before>
  Number extreme(const SyntaxNode& node, Before before) const {
    Number best = operand(node, 0);
    for (std::size_t i = 1; i < node.operands.size(); ++i)
      if (const Number other = operand(node, i); before(value_of(other), value_of(best))) best = other;
    return best;
  }

  const std::vector<SyntaxNode>& nodes_;
  std::span<const Number> values_;
};

}  // namespace

DifferentiableExpression::DifferentiableExpression(std::string text,
                                                   const std::vector<std::string>& variables)
    : text_(std::move(text)) {
  const Expression checked(text_, variables);  // says what is wrong with a formula
  nodes_ = parse_formula(text_, variables);
}

double DifferentiableExpression::operator()(std::span<const double> values) const {
  return Evaluation<double>(nodes_, values).of(nodes_.size() - 1);
}

Dual DifferentiableExpression::operator()(std::span<const Dual> values) const {
  return Evaluation<Dual>(nodes_, values).of(nodes_.size() - 1);
}

}  // namespace etendue
