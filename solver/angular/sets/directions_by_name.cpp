// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "base/errors.h"
#include "solver/angular/sets/direction_set.h"

namespace etendue {
namespace {

/// A set's name, maker, how its size grows with the order, and which orders it has.
struct Family {
  const char* name;
  DirectionSet (*make)(int);
  double (*count)(double order);  ///< a double, since squares of orders overflow
  int first = 1;
  int step = 1;  ///< 2: only even orders
  int last = 0;  ///< 0: as many as directions are accepted
  AngularSpace space = AngularSpace::sphere;
  const std::vector<int>& (*orders)() = nullptr;  ///< where they are not evenly spaced
};

constexpr std::array<Family, 8> families = {{
    {"product", directions_product, [](double n) { return 2 * n * n; }, 2, 2},
    {"triangular", directions_triangular, [](double n) { return n * (n + 2); }, 2, 2},
    {"double-gauss", directions_double_gauss, [](double n) { return 8 * n * n; }, 2},
    {"ldfe-sq", directions_ldfe_sq, [](double n) { return 96 * n * n; }},
    {"level-symmetric", directions_level_symmetric, [](double n) { return n * (n + 2); }, 2, 2, 16},
    {"thurgood", directions_thurgood, [](double n) { return 8 * n * n; }},
    {"lebedev", directions_lebedev, [](double n) { return (n + 1) * (n + 1) / 3; }, 3, 2, 131,
     AngularSpace::sphere, lebedev_degrees},
    {"flatland", directions_flatland, [](double n) { return n; }, 4, 4, 0, AngularSpace::plane},
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
  if (family.last > 0) return family.last;
  int order = family.first;
  while (family.count(order + family.step) <= most_directions) order += family.step;
  return order;
}

std::string accepted(const Family& family) {
  if (family.orders) return fmt::format("; use {}", fmt::join(family.orders(), ", "));
  return fmt::format("; use {}, {}, {} … {}", family.first, family.first + family.step,
                     family.first + 2 * family.step, largest_order(family));
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

AngularSpace angular_space(const std::string& set_name) {
  const Family* family = find_family(set_name);
  return family ? family->space : AngularSpace::sphere;
}

std::vector<int> sample_orders(const std::string& set_name, int most) {
  const Family* family = find_family(set_name);
  if (!family) return {};
  std::vector<int> candidates = {1, 2, 3, 4, 6, 8, 12, 16};
  if (family->orders) candidates = {5, 7, 11, 17, 23, 29, 35, 47, 65, 131};
  if (family->space == AngularSpace::plane) candidates = {8, 16, 32, 64, 128};
  std::erase_if(candidates, [&](int order) { return !check_direction_order(set_name, order).empty(); });
  if (candidates.size() > static_cast<std::size_t>(most)) candidates.resize(static_cast<std::size_t>(most));
  return candidates;
}

std::string check_direction_order(const std::string& name, int order) {
  const Family* family = find_family(name);
  if (!family) return "no order suits the unknown set \"" + name + "\"; use " + accepted_names();
  if (order < 1) return "must be positive" + accepted(*family);
  if (family->orders) {
    const std::vector<int>& orders = family->orders();
    return std::ranges::count(orders, order) > 0
               ? std::string()
               : "no rule of this degree has positive weights" + accepted(*family);
  }
  if (family->step == 4 && order % 4 != 0)
    return "must be a multiple of 4 (so that mirrors across x and y keep the set)" + accepted(*family);
  if (order % family->step != 0)
    return "must be even (the levels of a " + name + " set lie in pairs above and below the equator)" +
           accepted(*family);
  if (order < family->first)
    return "too small (one level in each hemisphere does not integrate z^2)" + accepted(*family);
  if (family->last > 0 && order > family->last)
    return "too large (" + name + " sets of higher order lose their positive weights)" + accepted(*family);
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
