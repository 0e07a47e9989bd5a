// SPDX-License-Identifier: AGPL-3.0-or-later
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "solver/angular/sets/direction_set.h"
#include "solver/angular/sets/octant.h"

namespace etendue {
namespace {

// The conditions hold to rounding of double only if they are solved with more digits.
using Real = long double;
using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

/// Levels of x, y and z of a direction, from 0, falling; directions that differ by their order share a
/// weight.
using Levels = std::array<int, 3>;

/// The directions of an octant of S_N: the levels of x, y and z add up to N/2 - 1.
std::vector<Levels> octant_levels(int order) {
  std::vector<Levels> all;
  const int sum = order / 2 - 1;
  for (int i = 0; i <= sum; ++i)
    for (int j = 0; i + j <= sum; ++j) all.push_back({i, j, sum - i - j});
  return all;
}

Levels sorted(Levels levels) {
  std::sort(levels.begin(), levels.end());
  return levels;
}

/// An S_N set for one choice of its first level: what follows from it.
class LevelSymmetric {
 public:
  LevelSymmetric(int order, Real first_level_squared) : order_(order), octant_(octant_levels(order)) {
    // Levels of x that agree with those of y and z: mu_i^2 rises by equal steps (Carlson 1971).
    const Real step = order == 2 ? 0 : 2 * (1 - 3 * first_level_squared) / (order - 2);
    for (int i = 0; i < order / 2; ++i) squares_.push_back(first_level_squared + i * step);
    for (const Levels& levels : octant_)
      if (levels == sorted(levels)) classes_.push_back(levels);
    solve_weights();
  }

  /// What is missing in the mean of z^order, which the weights do not care for.
  Real excess() const { return power_row(order_ / 2).dot(weights_) - Real(1) / (order_ + 1); }

  WeightedDirections directions() const {
    WeightedDirections octant;
    const auto level = [this](int i) {
      return static_cast<double>(std::sqrt(squares_[static_cast<std::size_t>(i)]));
    };
    for (const Levels& levels : octant_) {
      octant.directions.emplace_back(level(levels[0]), level(levels[1]), level(levels[2]));
      const Real weight = weights_[class_of(levels)] * std::numbers::pi_v<Real> / 2;
      octant.weights.push_back(static_cast<double>(weight));
    }
    return octant;
  }

 private:
  Eigen::Index class_of(const Levels& levels) const {
    return std::find(classes_.begin(), classes_.end(), sorted(levels)) - classes_.begin();
  }

  /// The sum of a function over the directions of each class.
  template <class Function>
  Vector row(Function function) const {
    Vector sums = Vector::Zero(static_cast<Eigen::Index>(classes_.size()));
    for (const Levels& levels : octant_) sums[class_of(levels)] += function(levels);
    return sums;
  }
  Real square(int level) const { return squares_[static_cast<std::size_t>(level)]; }
  Vector power_row(int half_power) const {
    return row([&](const Levels& levels) { return std::pow(square(levels[2]), half_power); });
  }

  /// Weights, which sum to 1 in an octant, from the means of 1, z^4, z^6 … z^(N-2). That of z^2 holds by
  /// symmetry. From S14 on these leave one weight open; the second invariant of the octahedron at degree 12
  /// fixes it.
  void solve_weights() {
    const auto count = static_cast<Eigen::Index>(classes_.size());
    Matrix conditions(count, count);
    Vector means(count);
    Eigen::Index next = 0;
    const auto add = [&](const Vector& sums, Real mean) {
      conditions.row(next) = sums.transpose();
      means[next++] = mean;
    };
    add(power_row(0), 1);
    for (int half_power = 2; half_power < order_ / 2; ++half_power)
      add(power_row(half_power), Real(1) / (2 * half_power + 1));
    if (next < count)
      add(row([&](const Levels& levels) {
            const Real product = square(levels[0]) * square(levels[1]) * square(levels[2]);
            return product * product;
          }),
          Real(1) / 5005);  // the mean of (x y z)^4
    weights_ = conditions.fullPivLu().solve(means);
  }

  int order_;
  std::vector<Levels> octant_;
  std::vector<Levels> classes_;
  std::vector<Real> squares_;  ///< of the levels, rising
  Vector weights_;             ///< [class]
};

/// The smallest mu_1^2 with which the mean of z^N is right too; the weights of others are not all positive.
Real first_level_squared(int order) {
  if (order == 2) return Real(1) / 3;
  const auto excess = [order](Real square) { return LevelSymmetric(order, square).excess(); };
  constexpr Real step = Real(1) / 400;  // roots are ten times as far apart
  Real low = step;
  const bool sign = excess(low) > 0;
  while ((excess(low + step) > 0) == sign) low += step;
  Real high = low + step;
  constexpr int halvings = 64;  // to the last bit
  for (int i = 0; i < halvings; ++i) {
    const Real middle = (low + high) / 2;
    ((excess(middle) > 0) == sign ? low : high) = middle;
  }
  return low;
}

}  // namespace

DirectionSet directions_level_symmetric(int order) {
  const WeightedDirections all =
      mirror_octant(LevelSymmetric(order, first_level_squared(order)).directions());
  return DirectionSet("level-symmetric", order, all.directions, all.weights);
}

}  // namespace etendue
