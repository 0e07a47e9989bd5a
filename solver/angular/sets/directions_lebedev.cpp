// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>

#include "solver/angular/sets/direction_set.h"
#include "solver/angular/sets/octant.h"

namespace etendue {

/// The text of solver/angular/sets/lebedev.txt, which describes its columns.
extern const char* const lebedev_table;

namespace {

struct Orbit {
  int kind = 0;
  double weight = 0;  ///< of a point; those of a rule sum to 1
  double a = 0, b = 0;
};

struct Rule {
  int degree = 0;
  std::vector<Orbit> orbits;
};

std::vector<Rule> read_rules() {
  std::vector<Rule> rules;
  std::istringstream lines(lebedev_table);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line.front() == '#') continue;
    std::istringstream words(line);
    if (line.front() == 'd') {
      std::string word;
      rules.emplace_back();
      words >> word >> rules.back().degree;
    } else {
      Orbit orbit;
      words >> orbit.kind >> orbit.weight;
      if (orbit.kind >= 4) words >> orbit.a;
      if (orbit.kind == 6) words >> orbit.b;
      rules.back().orbits.push_back(orbit);
    }
  }
  return rules;
}

const std::vector<Rule>& rules() {
  static const std::vector<Rule> read = read_rules();
  return read;
}

/// The third coordinate of a unit vector.
double rest(double a, double b) { return std::sqrt(1 - a * a - b * b); }

std::array<double, 3> point_of(const Orbit& orbit) {
  switch (orbit.kind) {
    case 1:
      return {0, 0, 1};
    case 2:
      return {0, std::sqrt(0.5), std::sqrt(0.5)};
    case 3:
      return {std::sqrt(1.0 / 3), std::sqrt(1.0 / 3), std::sqrt(1.0 / 3)};
    case 4:
      return {orbit.a, orbit.a, rest(orbit.a, orbit.a)};
    case 5:
      return {0, orbit.a, rest(orbit.a, 0)};
    default:
      return {orbit.a, orbit.b, rest(orbit.a, orbit.b)};
  }
}

/// All that permutations of the axes and changes of sign make of the orbit's point, each once.
void append_orbit(WeightedDirections& set, const Orbit& orbit) {
  std::array<double, 3> point = point_of(orbit);
  std::ranges::sort(point);
  do {
    for (int signs = 0; signs < 8; ++signs) {
      Vec3 direction;
      bool doubled = false;  // 0 and -0 are the same
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const bool negative = (signs >> axis & 1) != 0;
        doubled = doubled || (negative && point[axis] == 0);
        direction[static_cast<Eigen::Index>(axis)] = negative ? -point[axis] : point[axis];
      }
      if (doubled) continue;
      set.directions.push_back(direction);
      set.weights.push_back(4 * std::numbers::pi * orbit.weight);
    }
  } while (std::ranges::next_permutation(point).found);
}

}  // namespace

const std::vector<int>& lebedev_degrees() {
  static const std::vector<int> degrees = [] {
    std::vector<int> all;
    for (const Rule& rule : rules()) all.push_back(rule.degree);
    return all;
  }();
  return degrees;
}

DirectionSet directions_lebedev(int degree) {
  const auto rule = std::ranges::find(rules(), degree, &Rule::degree);
  if (rule == rules().end()) throw std::invalid_argument("no Lebedev rule of this degree");
  WeightedDirections set;
  for (const Orbit& orbit : rule->orbits) append_orbit(set, orbit);
  return DirectionSet("lebedev", degree, set.directions, set.weights);
}

}  // namespace etendue
