// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/expression/syntax.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <numbers>
#include <string_view>
#include <utility>

#include "base/errors.h"

namespace etendue {
namespace {

struct BinaryOperator {
  std::string_view text;
  Operation operation;
};

/// From the weakest to the strongest; two characters before one. ^ binds to the right and stands apart.
const std::array<std::vector<BinaryOperator>, 5> levels = {{
    {{"||", Operation::either}},
    {{"&&", Operation::both}},
    {{"<=", Operation::less_or_equal},
     {">=", Operation::greater_or_equal},
     {"==", Operation::equal},
     {"!=", Operation::unequal},
     {"<", Operation::less},
     {">", Operation::greater}},
    {{"+", Operation::add}, {"-", Operation::subtract}},
    {{"*", Operation::multiply}, {"/", Operation::divide}},
}};

constexpr std::array<std::pair<std::string_view, Operation>, 6> functions_of_several = {
    {{"atan2", Operation::atan2},
     {"sum", Operation::sum},
     {"avg", Operation::average},
     {"min", Operation::smallest},
     {"max", Operation::largest},
     {"polynomial", Operation::polynomial}}};

/// A parser by recursive descent: one function for each strength of binding.
class FormulaParser {
 public:
  FormulaParser(const std::string& text, const std::vector<std::string>& variables)
      : text_(text), variables_(variables) {}

  std::vector<SyntaxNode> parse() {
    choice();
    skip_blanks();
    if (at_ < text_.size()) fail();
    return std::move(nodes_);
  }

 private:
  std::size_t choice() {
    const std::size_t condition = binary(0);
    if (!take("?")) return condition;
    const std::size_t yes = choice();
    if (!take(":")) fail();
    const std::size_t no = choice();
    return add({.operation = Operation::choose, .operands = {condition, yes, no}});
  }

  std::size_t binary(std::size_t level) {
    if (level == levels.size()) return sign();
    std::size_t left = binary(level + 1);
    while (const BinaryOperator* found = take_operator(levels[level])) {
      const std::size_t right = binary(level + 1);
      left = add({.operation = found->operation, .operands = {left, right}});
    }
    return left;
  }

  // A sign binds as strongly as *: -x^2 is -(x^2).
  std::size_t sign() {
    if (take("-")) return add({.operation = Operation::negate, .operands = {sign()}});
    if (take("+")) return sign();
    const std::size_t base = primary();
    if (!take("^")) return base;
    const std::size_t exponent = sign();
    return add({.operation = Operation::power, .operands = {base, exponent}});
  }

  std::size_t primary() {
    skip_blanks();
    if (take("(")) {
      const std::size_t inner = choice();
      if (!take(")")) fail();
      return inner;
    }
    const char next = peek();
    if (std::isdigit(static_cast<unsigned char>(next)) != 0 || next == '.') return numeral();
    return named();
  }

  std::size_t numeral() {
    char* end = nullptr;
    const double value = std::strtod(text_.c_str() + at_, &end);
    const auto stop = static_cast<std::size_t>(end - text_.c_str());
    if (stop == at_) fail();
    at_ = stop;
    return add({.constant = value});
  }

  std::size_t named() {
    const std::size_t start = at_;
    while (std::isalnum(static_cast<unsigned char>(peek())) != 0 || peek() == '_') ++at_;
    const std::string name = text_.substr(start, at_ - start);
    if (name == "pi") return add({.constant = std::numbers::pi});
    if (name == "e") return add({.constant = std::numbers::e});
    const auto variable = std::find(variables_.begin(), variables_.end(), name);
    if (variable != variables_.end())
      return add({.operation = Operation::variable,
                  .variable = static_cast<std::size_t>(variable - variables_.begin())});
    if (const UnaryFunction* function = find_unary_function(name))
      return add({.operation = Operation::unary, .function = function, .operands = arguments(1, 1)});
    for (const auto& [known, operation] : functions_of_several)
      if (known == name) {
        const bool two = operation == Operation::atan2;
        const bool least_two = two || operation == Operation::polynomial;
        return add({.operation = operation, .operands = arguments(least_two ? 2 : 1, two ? 2 : 1000)});
      }
    fail();
  }

  std::vector<std::size_t> arguments(std::size_t least, std::size_t most) {
    if (!take("(")) fail();
    std::vector<std::size_t> operands = {choice()};
    while (take(",")) operands.push_back(choice());
    if (!take(")") || operands.size() < least || operands.size() > most) fail();
    return operands;
  }

  std::size_t add(SyntaxNode node) {
    nodes_.push_back(std::move(node));
    return nodes_.size() - 1;
  }

  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  void skip_blanks() {
    while (std::isspace(static_cast<unsigned char>(peek())) != 0) ++at_;
  }
  bool take(std::string_view token) {
    skip_blanks();
    if (text_.compare(at_, token.size(), token) != 0) return false;
    at_ += token.size();
    return true;
  }
  const BinaryOperator* take_operator(const std::vector<BinaryOperator>& operators) {
    for (const BinaryOperator& candidate : operators)
      if (take(candidate.text)) return &candidate;
    return nullptr;
  }
  [[noreturn]] void fail() const {
    throw InputError("has no derivative that can be found (character " + std::to_string(at_ + 1) +
                     "); use + - * / ^, comparisons, && ||, ?: and functions such as sin, exp, sqrt");
  }

  const std::string& text_;
  const std::vector<std::string>& variables_;
  std::size_t at_ = 0;
  std::vector<SyntaxNode> nodes_;
};

}  // namespace

std::vector<SyntaxNode> parse_formula(const std::string& text, const std::vector<std::string>& variables) {
  return FormulaParser(text, variables).parse();
}

}  // namespace etendue
