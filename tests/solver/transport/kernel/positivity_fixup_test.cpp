// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/kernel/positivity_fixup.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace etendue::positivity_fixup_test {
namespace {

struct Cell {
  double weights[4];
  double balance;
  double values[4];  ///< of the linear problem, which satisfy the balance
};

/// Cells with light entering, void to thick, lumped or not.
class Cells {
 public:
  Cell next() {
    std::uniform_real_distribution<double> uniform(-1, 1);
    double a[4] = {uniform(random_), uniform(random_), uniform(random_), 0};
    a[3] = -(a[0] + a[1] + a[2]);
    const ProjectedAreas<double> areas = projected_areas(a);
    const bool lumped = count_ % 2 == 0;
    const double extinction = count_++ % 5 == 0 ? 0 : std::pow(10, 4 * uniform(random_));
    const double alpha = (lumped ? 3 : 0.6) * extinction, beta = lumped ? 0 : alpha;
    double right[4] = {};
    for (int f = 0; f < 4; ++f) {
      const double inflow[3] = {bright(), bright(), bright()};
      add_inflow(areas, f, inflow, right);
    }
    Cell cell{};
    balance_weights(areas, alpha, beta, cell.weights);
    cell.balance = right[0] + right[1] + right[2] + right[3];
    solve_cell(areas, invert_cell(areas, alpha, beta), right, cell.values);
    return cell;
  }
  double bright() {
    const double value = std::uniform_real_distribution<double>(-2, 1)(random_);
    return std::max(value, 0.0);  // mostly dark
  }
  std::mt19937_64& random() { return random_; }

 private:
  std::mt19937_64 random_{11};
  int count_ = 0;
};

double dot(const double (&c)[4], const double (&u)[4]) {
  return c[0] * u[0] + c[1] * u[1] + c[2] * u[2] + c[3] * u[3];
}

double distance(const double (&a)[4], const double (&b)[4]) {
  return std::hypot(std::hypot(a[0] - b[0], a[1] - b[1]), std::hypot(a[2] - b[2], a[3] - b[3]));
}

bool any_negative(const double (&u)[4]) { return *std::min_element(u, u + 4) < 0; }

TEST(PositivityFixup, WeightsAreThoseOfTheCellsBalance) {
  Cells cells;
  for (int trial = 0; trial < 20000; ++trial) {
    const Cell cell = cells.next();
    double size = 0;
    for (int i = 0; i < 4; ++i) size += cell.weights[i] * std::abs(cell.values[i]);
    EXPECT_NEAR(dot(cell.weights, cell.values), cell.balance, 1e-12 * size);
  }
}

TEST(PositivityFixup, KeepsTheBalanceWithoutNegativeValues) {
  Cells cells;
  int met = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const Cell cell = cells.next();
    if (!any_negative(cell.values)) continue;
    ++met;
    for (const auto fix : {rescale_to_balance, project_on_balance}) {
      double u[4];
      std::copy(cell.values, cell.values + 4, u);
      fix(cell.weights, cell.balance, u);
      EXPECT_FALSE(any_negative(u));
      EXPECT_NEAR(dot(cell.weights, u), cell.balance, 1e-13 * cell.balance);
    }
  }
  EXPECT_GT(met, 5000);
}

TEST(PositivityFixup, ProjectionIsTheNearestOfAll) {
  Cells cells;
  constexpr double rounding = 1e-14;  // of values of order 1
  std::exponential_distribution<double> share;
  for (int trial = 0; trial < 2000; ++trial) {
    const Cell cell = cells.next();
    if (!any_negative(cell.values)) continue;
    double nearest[4], rescaled[4];
    std::copy(cell.values, cell.values + 4, nearest);
    std::copy(cell.values, cell.values + 4, rescaled);
    project_on_balance(cell.weights, cell.balance, nearest);
    rescale_to_balance(cell.weights, cell.balance, rescaled);
    const double least = distance(nearest, cell.values);
    EXPECT_LE(least, distance(rescaled, cell.values) + rounding);
    for (int other = 0; other < 50; ++other) {
      double u[4];
      for (double& value : u) value = std::max(0.0, share(cells.random()) - 0.5);
      const double sum = dot(cell.weights, u);
      if (!(sum > 0)) continue;
      for (double& value : u) value *= cell.balance / sum;
      EXPECT_LE(least, distance(u, cell.values) + rounding);
    }
  }
}

TEST(PositivityFixup, CellWithoutLightStaysDark) {
  const double weights[4] = {1, 2, 3, 0};
  for (const auto fix : {rescale_to_balance, project_on_balance}) {
    double u[4] = {-0.5, 0.25, 0, -1};
    fix(weights, 0, u);
    for (const double value : u) EXPECT_EQ(value, 0);
  }
}

}  // namespace
}  // namespace etendue::positivity_fixup_test
