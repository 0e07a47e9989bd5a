// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/expression/expression.h"

#include <muParser.h>

#include <algorithm>
#include <cassert>
#include <cctype>
#include <numbers>
#include <set>

#include "base/blackbody.h"
#include "base/errors.h"

namespace etendue {
namespace {

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += name + ", ";
  return text;
}

std::string what_is_accepted(const std::vector<std::string>& variables) {
  return "; give a formula in " + joined(variables) +
         "pi and e with + - * / ^, comparisons, ?: and functions such as "
         "sin, exp, sqrt, abs, min, max";
}

/// muParser's message in lower case, without its own count of characters, which starts at 0.
std::string plain_message(std::string message) {
  for (const char* ending : {" found at position", " at expression position", " at position"})
    if (const auto at = message.find(ending); at != std::string::npos) message.erase(at);
  while (!message.empty() && (message.back() == '.' || message.back() == ' ')) message.pop_back();
  if (message.ends_with(" \"")) message.erase(message.size() - 2, 1);  // a blank that muParser appends
  if (!message.empty()) message[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(message[0])));
  return message;
}

/// Where the text assigns to a variable (muParser would), else npos.
std::size_t find_assignment(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '=') continue;
    if (i + 1 < text.size() && text[i + 1] == '=')
      ++i;
    else if (i == 0 || std::string("<>!").find(text[i - 1]) == std::string::npos)
      return i;
  }
  return std::string::npos;
}

double call(void* function, double x, double y, double z) {
  return static_cast<const PlaceFunction*>(function)->at(Vec3(x, y, z));
}

/// The first argument is that of the polynomial, the others its terms from the constant one on.
double polynomial(const double* arguments, int count) {
  if (count < 2) throw mu::ParserError("polynomial() needs a variable and terms");
  double sum = arguments[count - 1];
  for (int i = count - 1; i-- > 1;) sum = sum * arguments[0] + arguments[i];
  return sum;
}

}  // namespace

struct Expression::Parser {
  Parser(const Formula& formula, const std::vector<std::string>& variables) : values(variables.size(), 0.0) {
    parser.ClearConst();  // muParser's own _pi has only 13 digits
    parser.DefineConst("pi", std::numbers::pi);
    parser.DefineConst("e", std::numbers::e);
    parser.DefineFun("blackbody_fraction", blackbody_fraction);
    parser.DefineFun("polynomial", polynomial);
    for (std::size_t i = 0; i < variables.size(); ++i) parser.DefineVar(variables[i], &values[i]);
    for (const auto& [name, function] : formula.functions)
      parser.DefineFunUserData(name, call, const_cast<PlaceFunction*>(function.get()), false);
    parser.SetExpr(formula.text);
    for (const auto& [name, address] : parser.GetUsedVar()) used.insert(name);
    parser.Eval();  // muParser parses at the first evaluation
    results = parser.GetNumResults();
  }

  mu::Parser parser;
  std::vector<double> values;  ///< [variable]; muParser keeps their addresses
  std::set<std::string> used;
  int results = 0;
};

Expression::Expression(Formula formula, std::vector<std::string> variables)
    : formula_(std::move(formula)), variables_(std::move(variables)) {
  if (const std::size_t at = find_assignment(formula_.text); at != std::string::npos)
    throw InputError("assignment (character " + std::to_string(at + 1) + "); use == to compare");
  try {
    parser_ = std::make_unique<Parser>(formula_, variables_);
  } catch (const mu::Parser::exception_type& error) {
    const int last = static_cast<int>(formula_.text.size());
    throw InputError(plain_message(error.GetMsg()) + " (character " +
                     std::to_string(std::clamp(error.GetPos() + 1, 1, std::max(last, 1))) + ")" +
                     what_is_accepted(variables_));
  }
  if (parser_->results != 1)
    throw InputError("several values (separated by commas)" + what_is_accepted(variables_));
}

Expression::~Expression() = default;
Expression::Expression(const Expression& other) : Expression(other.formula_, other.variables_) {}
Expression& Expression::operator=(const Expression& other) {
  if (this != &other) *this = Expression(other);
  return *this;
}
Expression::Expression(Expression&&) noexcept = default;
Expression& Expression::operator=(Expression&&) noexcept = default;

double Expression::operator()(std::span<const double> values) const {
  assert(values.size() == variables_.size());
  std::copy(values.begin(), values.end(), parser_->values.begin());
  return parser_->parser.Eval();
}

bool Expression::uses(const std::string& variable) const { return parser_->used.contains(variable); }

}  // namespace etendue
