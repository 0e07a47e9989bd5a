// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/kernel/cell_balance.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <random>

namespace etendue::cell_balance_test {
namespace {

/// The four equations as docs/theory/theory.md writes them, times 12.
Eigen::Matrix4d matrix(const double (&a)[4], double volume_extinction, bool lumped) {
  Eigen::Matrix4d result;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const double same = i == j ? 1 : 0;
      double entry = lumped ? 3 * volume_extinction * same : 0.6 * volume_extinction * (1 + same);
      entry += a[i];
      for (int f = 0; f < 4; ++f)
        if (f != i && f != j) entry += std::max(a[f], 0.0) * (1 + same);
      result(i, j) = entry;
    }
  return result;
}

struct RandomCell {
  double a[4];
  double right[4];
  double volume_extinction;
};

class CellBalance : public testing::TestWithParam<bool> {
 protected:
  RandomCell next() {
    std::uniform_real_distribution<double> uniform(-1, 1);
    RandomCell cell{};
    cell.a[3] = 0;
    for (int f = 0; f < 3; ++f) {
      cell.a[f] = uniform(random_);
      cell.a[3] -= cell.a[f];
    }
    for (double& value : cell.right) value = uniform(random_);
    cell.volume_extinction = count_++ % 5 == 0 ? 0 : std::pow(10, 4 * uniform(random_));
    return cell;
  }

  void solve(const RandomCell& cell, double (&u)[4]) const {
    const bool lumped = GetParam();
    const double alpha = (lumped ? 3 : 0.6) * cell.volume_extinction;
    const ProjectedAreas<double> areas = projected_areas(cell.a);
    solve_cell(areas, invert_cell(areas, alpha, lumped ? 0.0 : alpha), cell.right, u);
  }

 private:
  std::mt19937_64 random_{7};
  int count_ = 0;
};

TEST_P(CellBalance, ClosedFormEqualsElimination) {
  for (int trial = 0; trial < 20000; ++trial) {
    const RandomCell cell = next();
    double u[4];
    solve(cell, u);
    const Eigen::Vector4d expected = matrix(cell.a, cell.volume_extinction, GetParam())
                                         .partialPivLu()
                                         .solve(Eigen::Map<const Eigen::Vector4d>(cell.right));
    const double size = expected.lpNorm<Eigen::Infinity>();
    // Nearly parallel faces in a void make the matrix itself ill-conditioned: compare by the residual too.
    const Eigen::Vector4d residual =
        matrix(cell.a, cell.volume_extinction, GetParam()) * Eigen::Map<Eigen::Vector4d>(u) -
        Eigen::Map<const Eigen::Vector4d>(cell.right);
    const double scale = matrix(cell.a, cell.volume_extinction, GetParam()).lpNorm<Eigen::Infinity>() * size;
    EXPECT_LT(residual.lpNorm<Eigen::Infinity>(), 1e-14 * scale) << trial;
  }
}

TEST_P(CellBalance, ColumnSumsAreTheBalanceOfTheCell) {
  for (int trial = 0; trial < 1000; ++trial) {
    const RandomCell cell = next();
    double u[4];
    solve(cell, u);
    // Twelfths: absorbed 3 sigma V (sum u), leaving 4 p_f (sum of u over the face).
    double out = 3 * cell.volume_extinction * (u[0] + u[1] + u[2] + u[3]);
    double size = std::abs(out);
    for (int f = 0; f < 4; ++f)
      for (int i = 0; i < 4; ++i)
        if (i != f) {
          out += 4 * std::max(cell.a[f], 0.0) * u[i];
          size += std::abs(4 * std::max(cell.a[f], 0.0) * u[i]);
        }
    const double in = cell.right[0] + cell.right[1] + cell.right[2] + cell.right[3];
    EXPECT_NEAR(out, in, 1e-13 * (size + 4)) << trial;
  }
}

TEST_P(CellBalance, ConstantInflowInVoidStaysConstant) {
  for (int trial = 0; trial < 1000; ++trial) {
    RandomCell cell = next();
    cell.volume_extinction = 0;
    for (double& value : cell.right) value = 0;
    const ProjectedAreas<double> areas = projected_areas(cell.a);
    const double ones[3] = {1, 1, 1};
    for (int f = 0; f < 4; ++f) add_inflow(areas, f, ones, cell.right);
    double u[4];
    solve(cell, u);
    for (const double value : u) EXPECT_NEAR(value, 1, 1e-13);
  }
}

INSTANTIATE_TEST_SUITE_P(Mass, CellBalance, testing::Values(false, true),
                         [](const auto& mass) { return mass.param ? "Lumped" : "Consistent"; });

TEST(LumpedCellBalance, KeepsThickCellsNearlyPositive) {
  // Unit inflow through one face of an optically thick cell: the consistent mass swings far below zero.
  const double a[4] = {-1, 0.5, 0.3, 0.2};
  const ProjectedAreas<double> areas = projected_areas(a);
  double right[4] = {};
  const double ones[3] = {1, 1, 1};
  add_inflow(areas, 0, ones, right);
  double consistent[4], lumped[4];
  const double thick = 100;
  solve_cell(areas, invert_cell(areas, 0.6 * thick, 0.6 * thick), right, consistent);
  solve_cell(areas, invert_cell(areas, 3 * thick, 0.0), right, lumped);
  EXPECT_LT(consistent[0], -0.01);
  EXPECT_GT(lumped[0], -1e-4);
}

}  // namespace
}  // namespace etendue::cell_balance_test
