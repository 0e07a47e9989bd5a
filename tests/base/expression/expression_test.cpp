// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/expression/expression.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/blackbody.h"
#include "base/errors.h"

namespace etendue::expression_test {
namespace {

double value_at(const Expression& formula, double x, double y, double z) {
  return formula(std::array{x, y, z});
}

Expression in_xyz(const std::string& text) { return Expression(text, {"x", "y", "z"}); }

std::string message_of(const std::string& text) {
  try {
    in_xyz(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

const std::string accepted =
    "; give a formula in x, y, z, pi and e with + - * / ^, comparisons, ?: and functions such as sin, exp, "
    "sqrt, "
    "abs, min, max";

TEST(Expression, EvaluatesFormulasInItsVariables) {
  EXPECT_DOUBLE_EQ(value_at(in_xyz("0.1 + 0.05*sin(3*x)*y - z^2"), 0.5, 2, 3),
                   0.1 + 0.05 * std::sin(1.5) * 2 - 9);
  EXPECT_DOUBLE_EQ(value_at(in_xyz("x > 0.5 && y <= 1 ? 2 : 3"), 0.6, 1, 0), 2);
  EXPECT_DOUBLE_EQ(value_at(in_xyz("(x == 1) + (y != 1)"), 1, 1, 0), 1);
  EXPECT_DOUBLE_EQ(value_at(in_xyz("-2^2 + 2^3^2"), 0, 0, 0), 508);
}

TEST(Expression, KnowsItsConstantsInFullPrecision) {
  EXPECT_EQ(value_at(in_xyz("pi"), 0, 0, 0), std::numbers::pi);
  EXPECT_EQ(value_at(in_xyz("e"), 0, 0, 0), std::numbers::e);
  EXPECT_EQ(message_of("_pi"), "unexpected token \"_pi\" (character 1)" + accepted);
  EXPECT_DOUBLE_EQ(value_at(in_xyz("log(e)"), 0, 0, 0), 1);  // log is natural
}

TEST(Expression, KnowsPolynomials) {
  EXPECT_EQ(value_at(in_xyz("polynomial(x, 3, y, 2)"), 10, 5, 0), 253);
  EXPECT_EQ(value_at(in_xyz("polynomial(x, 3)"), 10, 5, 0), 3);
  EXPECT_NE(message_of("polynomial(x)").find("needs a variable and terms"), std::string::npos);
  EXPECT_NE(message_of("polynomial()"), "");
}

TEST(Expression, KnowsTheSpectrumOfABlackbody) {
  EXPECT_EQ(value_at(in_xyz("blackbody_fraction(x*y)"), 700, 3000, 0), blackbody_fraction(2.1e6));
}

TEST(Expression, KnowsWhichVariablesItUses) {
  const Expression formula = in_xyz("0*x + z");
  EXPECT_TRUE(formula.uses("x"));
  EXPECT_FALSE(formula.uses("y"));
  EXPECT_TRUE(formula.uses("z"));
  EXPECT_EQ(formula.text(), "0*x + z");
}

TEST(Expression, CopiesAndMovesIndependently) {
  Expression first = in_xyz("x + 1");
  const Expression copy = first;
  EXPECT_DOUBLE_EQ(value_at(copy, 1, 0, 0), 2);
  EXPECT_DOUBLE_EQ(value_at(first, 5, 0, 0), 6);
  EXPECT_DOUBLE_EQ(value_at(copy, 2, 0, 0), 3);
  const Expression moved = std::move(first);
  EXPECT_DOUBLE_EQ(value_at(moved, 3, 0, 0), 4);
  Expression assigned = in_xyz("y");
  assigned = copy;
  EXPECT_DOUBLE_EQ(value_at(assigned, 4, 0, 0), 5);
  EXPECT_TRUE(assigned.uses("x"));
}

TEST(Expression, PassesOnWhatIsNotFinite) {
  EXPECT_TRUE(std::isinf(value_at(in_xyz("1/x"), 0, 0, 0)));
  EXPECT_TRUE(std::isnan(value_at(in_xyz("sqrt(x)"), -1, 0, 0)));
}

TEST(Expression, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(message_of("0.1 + foo"), "unexpected token \"foo\" (character 7)" + accepted);
  EXPECT_EQ(message_of("$"), "unexpected token \"$\" (character 1)" + accepted);
  EXPECT_EQ(message_of(""), "expression is empty (character 1)" + accepted);
  EXPECT_EQ(message_of("sin("), "unexpected end of expression (character 4)" + accepted);
  EXPECT_EQ(message_of("sin()"), "too few parameters for function \"sin\" (character 5)" + accepted);
  EXPECT_EQ(message_of("x y"), "unexpected variable \"y\" (character 3)" + accepted);
  EXPECT_EQ(message_of("1, 2"), "several values (separated by commas)" + accepted);
  EXPECT_EQ(message_of("wx"), "unexpected token \"wx\" (character 1)" + accepted);
}

TEST(Expression, RefusesAssignments) {
  EXPECT_EQ(message_of("x = 3"), "assignment (character 3); use == to compare");
  EXPECT_EQ(message_of("x < 1 ? 2 : y = 4"), "assignment (character 15); use == to compare");
  EXPECT_EQ(message_of("x <= 3 == (y >= 1) != (z == 2)"), "");
}

}  // namespace
}  // namespace etendue::expression_test
