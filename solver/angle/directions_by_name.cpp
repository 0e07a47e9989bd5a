// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "mesh/base/errors.h"
#include "solver/angle/direction_set.h"

namespace etendue {
namespace {

/// A set's name, maker and how its size grows with the order.
struct Family {
  const char* name;
  DirectionSet (*make)(int);
  double (*count)(double order);  ///< a double, since squares of orders overflow
  bool even;                      ///< only even orders
};

constexpr std::array<Family, 3> families = {{
    {"product", directions_product, [](double n) { return 2 * n * n; }, true},
    {"triangular", directions_triangular, [](double n) { return n * (n + 2); }, true},
    {"ldfe-sq", directions_ldfe_sq, [](double n) { return 96 * n * n; }, false},
}};

// Every direction costs a sweep in every iteration: beyond this a run takes days even on small meshes, and
// an order like 1000 is a slip of the keyboard.
constexpr int most_directions = 100000;

const Family* find_family(const std::string& name) {
  const auto found = std::find_if(families.begin(), families.end(),
                                  [&name](const Family& family) { return name == family.name; });
  return found == families.end() ? nullptr : &*found;
}

int largest_order(const Family& family) {
  int order = family.even ? 2 : 1;
  const int step = order;
  while (family.count(order + step) <= most_directions) order += step;
  return order;
}

std::string accepted(const Family& family) {
  return std::string("; use ") + (family.even ? "2, 4, 6" : "1, 2, 3") + " … " +
         std::to_string(largest_order(family));
}

std::string accepted_names() {
  std::string text;
  for (const Family& family : families) text += (text.empty() ? "" : ", ") + std::string(family.name);
  return text;
}

}  // namespace

std::vector<std::string> direction_set_names() {
  std::vector<std::string> names;
  names.reserve(families.size());
  for (const Family& family : families) names.emplace_back(family.name);
  return names;
}

std::string check_direction_order(const std::string& name, int order) {
  const Family* family = find_family(name);
  if (!family) return "no order suits the unknown set \"" + name + "\"; use " + accepted_names();
  if (order < 1) return "must be positive" + accepted(*family);
  if (family->even && order % 2 != 0)
    return "must be even (the levels of a " + name + " set lie in pairs above and below the equator)" +
           accepted(*family);
  if (order > largest_order(*family))
    return "too large (" + fmt::format("{:.0f}", family->count(order)) + " directions, more than " +
           std::to_string(most_directions) + ": each costs a sweep in every iteration)" + accepted(*family);
  return {};
}

DirectionSet make_directions(const std::string& name, int order) {
  const Family* family = find_family(name);
  if (!family)
    throw InputError("directions.set = \"" + name + "\": unknown in this version; use " + accepted_names());
  if (const std::string problem = check_direction_order(name, order); !problem.empty())
    throw InputError("directions.order = " + std::to_string(order) + ": " + problem);
  return family->make(order);
}

}  // namespace etendue
