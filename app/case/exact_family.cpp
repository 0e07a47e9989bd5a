// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/exact_family.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace etendue {
namespace {

/// What a family is in the coordinates X, Y, Z.
struct Member {
  const char* name;
  const char* formula;
  double order;   ///< as the elements' degree grows; theirs + 1 where that is less
  double degree;  ///< in space
};

constexpr double any_value = std::numeric_limits<double>::infinity();

// The border (e x w).(X, Y, Z) of a shadow, whose gradient is normal to w.
constexpr const char* border = "((0.48*wz - 0.8*wy)*X + (0.8*wx - 0.36*wz)*Y + (0.36*wy - 0.48*wx)*Z)";

// Jumps within cells leave order 1/2 of the best approximation in L2, every derivative that is continuous
// adds one.
constexpr Member members[] = {
    {"polynomial", "(1 + 0.3*wx - 0.2*wy + 0.1*wz)*(4 + S)", any_value, any_value},
    {"trigonometric",
     "3 + sin(2*X + 2)*cos(2*Y - Z + 0.5)*(1 + 0.5*wx + 0.3*wy*wz) + 0.5*cos(3*Z + 1.5)*wx^2", any_value,
     any_value},
    {"angular-exponential", "(2 + X - Y)*exp(2*wx + wy*wz)", any_value, 1},
    {"jump", "2 + (B > 0 ? 1 : 0)", 0.5, any_value},
    {"kink", "2 + max(0, B)", 1.5, any_value},
    {"bend", "2 + max(0, B)^2", 2.5, any_value}};

const Member& member(const std::string& name) {
  return *std::find_if(std::begin(members), std::end(members),
                       [&](const Member& m) { return name == m.name; });
}

void replace(std::string& text, char what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, 1, by);
}

/// 0.5 X - 0.3 Y + 0.2 Z in its powers up to the degree.
std::string powers(int degree) {
  std::string sum = "0";
  for (int power = 1; power <= degree; ++power) sum += fmt::format(" + (0.5*X - 0.3*Y + 0.2*Z)^{}", power);
  return "(" + sum + ")";
}

}  // namespace

const std::vector<std::string>& exact_family_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Member& m : members) all.emplace_back(m.name);
    return all;
  }();
  return names;
}

std::string exact_formula(const ExactFamily& family) {
  std::string formula = member(family.name).formula;
  replace(formula, 'S', powers(family.degree));
  replace(formula, 'B', border);
  for (int axis = 0; axis < 3; ++axis)
    replace(formula, "XYZ"[axis],
            fmt::format("(({} - ({}))/{})", "xyz"[axis], family.center[axis], family.length));
  return formula;
}

std::optional<double> expected_order(const ExactFamily& family, int order) {
  const Member& m = member(family.name);
  const double degree = family.name == "polynomial" ? family.degree : m.degree;
  if (degree <= order) return std::nullopt;
  return std::min(m.order, order + 1.0);
}

}  // namespace etendue
