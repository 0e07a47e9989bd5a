// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/media/angular_formula.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <regex>
#include <utility>

#include "base/errors.h"

namespace etendue {
namespace {

constexpr std::array direction_names = {"wx", "wy", "wz"};

/// Directions and their shares, which sum to 1.
std::vector<std::pair<Vec3, double>> mean_rule(bool in_plane) {
  std::vector<std::pair<Vec3, double>> rule;
  if (in_plane) {
    for (int i = 0; i < 8; ++i) {
      const double angle = std::numbers::pi * (i + 0.5) / 4;
      rule.emplace_back(Vec3(std::cos(angle), std::sin(angle), 0), 1.0 / 8);
    }
    return rule;
  }
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0}) rule.emplace_back(sign * Vec3::Unit(axis), 1.0 / 15);
  for (int octant = 0; octant < 8; ++octant)
    rule.emplace_back(Vec3(octant & 1 ? 1 : -1, octant & 2 ? 1 : -1, octant & 4 ? 1 : -1) / std::sqrt(3.0),
                      3.0 / 40);
  return rule;
}

}  // namespace

AngularFormula::AngularFormula(Formula formula) : formula_(std::move(formula), angular_variables()) {}

double AngularFormula::at(const Vec3& point, const Vec3& direction) const {
  return formula_(std::array{point.x(), point.y(), point.z(), sign_ * direction.x(), sign_ * direction.y(),
                             sign_ * direction.z()});
}

AngularFormula AngularFormula::reversed() const {
  AngularFormula result = *this;
  result.sign_ = -sign_;
  return result;
}

bool AngularFormula::depends_on_direction() const {
  return formula_.uses("wx") || formula_.uses("wy") || formula_.uses("wz");
}

bool AngularFormula::depends_on_place() const {
  return formula_.uses("x") || formula_.uses("y") || formula_.uses("z");
}

const std::vector<std::string>& angular_variables() {
  static const std::vector<std::string> names = {"x", "y", "z", "wx", "wy", "wz"};
  return names;
}

bool depends_on_direction(const Formula& formula) {
  try {
    return AngularFormula(formula).depends_on_direction();
  } catch (const InputError&) {
    return false;
  }
}

Formula mean_over_directions(const Formula& formula, bool in_plane) {
  std::string mean;
  for (const auto& [direction, share] : mean_rule(in_plane)) {
    std::string term = formula.text;
    for (std::size_t axis = 0; axis < direction_names.size(); ++axis)
      term = std::regex_replace(term, std::regex(fmt::format("\\b{}\\b", direction_names[axis])),
                                fmt::format("({:.17g})", direction[static_cast<Eigen::Index>(axis)]));
    mean += fmt::format("{}{:.17g}*({})", mean.empty() ? "" : "+", share, term);
  }
  return {mean, formula.functions};
}

}  // namespace etendue
