// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/scattering/moment_orbits.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdlib>
#include <random>
#include <vector>

#include "base/errors.h"
#include "solver/transport/kernel/sweep_kernel.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::moment_orbits_test {
namespace {

Problem cube_problem(const TetrahedralMesh& mesh) {
  return uniform_problem(mesh, uniform_medium(1, 1, 0.5, 1, PhaseHenyeyGreenstein{0.8}),
                         uniform_wall(1, 0, 0, 0));
}

/// -1 where an odd number of mirrors turns ordinate r of an orbit about and harmonics of a class are odd
/// there.
double sign(int c, std::size_t r) { return std::popcount(static_cast<unsigned>(c) & r) % 2 == 0 ? 1 : -1; }

/// Every ordinate is in one orbit, all of an orbit in one batch, and harmonics have the signs of their
/// class.
void expect_orbits(const DirectionSet& set, int size) {
  const TetrahedralMesh mesh = cube_mesh(0.1);
  const OrdinateSchedule schedule(cube_problem(mesh), set, Batches::of_images);
  const DiscreteHarmonics harmonics(set, 5);
  const MomentOrbits orbits(set, harmonics, schedule);
  ASSERT_EQ(orbits.size(), size) << set.name();
  ASSERT_EQ(orbits.count() * size, set.count());
  std::vector<int> seen(static_cast<std::size_t>(set.count()), 0);
  for (int orbit = 0; orbit < orbits.count(); ++orbit)
    for (std::size_t r = 0; r < static_cast<std::size_t>(size); ++r) {
      const OrdinateIndex m = orbits.ordinates(orbit)[r];
      ++seen[m.at()];
      EXPECT_EQ(schedule.place_of(m) / schedule.batch(), orbit * size / schedule.batch());
      for (int c = 0; c < size; ++c)
        for (int at = orbits.class_begin()[static_cast<std::size_t>(c)];
             at < orbits.class_begin()[static_cast<std::size_t>(c) + 1]; ++at) {
          const int k = orbits.order()[static_cast<std::size_t>(at)];
          EXPECT_NEAR(harmonics.value(k, m), sign(c, r) * harmonics.value(k, orbits.ordinates(orbit)[0]),
                      1e-12);
        }
    }
  EXPECT_EQ(seen, std::vector<int>(seen.size(), 1));
  EXPECT_EQ(orbits.class_begin().back(), harmonics.count());
}

TEST(MomentOrbits, HarmonicsOfOneClassDifferByTheirSignsAlone) {
  for (const DirectionSet& set : {directions_product(6), directions_ldfe_sq(1), directions_level_symmetric(8),
                                  directions_triangular(8), directions_double_gauss(3)})
    expect_orbits(set, 8);
}

TEST(MomentOrbits, ArePairsOfOppositesWhereMirrorsTurnOrdinatesIntoNoOthers) {
  // Some of Lebedev's stand on the axes.
  expect_orbits(directions_lebedev(11), 2);
  expect_orbits(rotated_copies(directions_product(4), 2, 7)[1], 2);
}

/// Moments and radiance of some rows at orbits of ordinates, with factors that mean nothing.
class MomentProduct : public testing::TestWithParam<int> {
 protected:
  static constexpr int moments = 11, orbits = 11, rows = 5;

  MomentProduct() {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> number(-1, 1);
    for (std::vector<double>* values : {&matrix, &moment_rows, &radiance})
      for (double& value : *values) value = number(random);
    for (int k = 0; k < moments; ++k) order[static_cast<std::size_t>(k)] = (7 * k + 2) % moments;
    for (int c = 0; c <= size; ++c)
      class_begin.push_back(c == size ? moments : (2 * c * moments) / (3 * size));
    for (int d = 0; d < orbits * size; ++d)
      directions.push_back(&radiance[static_cast<std::size_t>(d * rows) * length]);
  }
  void TearDown() override { unsetenv("ETENDUE_ISA"); }

  MomentTask task() {
    MomentTask task;
    task.row_length = length;
    task.moments = moments;
    task.orbit_size = size;
    task.class_begin = class_begin.data();
    task.order = order.data();
    task.orbits = orbits;
    task.matrix = matrix.data();
    task.moment_rows = moment_rows.data();
    task.direction_rows = directions.data();
    task.last_row = rows;
    return task;
  }

  /// [direction][moment]
  double factor(int d, int k) const {
    int at = 0, c = 0;
    while (order[static_cast<std::size_t>(at)] != k) ++at;
    while (class_begin[static_cast<std::size_t>(c) + 1] <= at) ++c;
    return sign(c, static_cast<std::size_t>(d % size)) *
           matrix[static_cast<std::size_t>(at * orbits + d / size)];
  }
  double& moment(int row, int k, std::size_t x) {
    return moment_rows[static_cast<std::size_t>(row * moments + k) * length + x];
  }
  double& value(int d, int row, std::size_t x) {
    return radiance[static_cast<std::size_t>(d * rows + row) * length + x];
  }

  static constexpr std::size_t bands = 2, length = 4 * bands;
  const int size = GetParam();
  std::vector<double> matrix = std::vector<double>(moments * orbits);
  std::vector<double> moment_rows = std::vector<double>(rows * moments * length);
  std::vector<double> radiance = std::vector<double>(static_cast<std::size_t>(orbits * size * rows) * length);
  std::vector<int> order = std::vector<int>(moments);
  std::vector<int> class_begin;
  std::vector<double*> directions;
};

TEST_P(MomentProduct, IsThatOfAllFactorsBothWays) {
  for (const char* isa : {"baseline", "avx2", "avx512"}) {
    setenv("ETENDUE_ISA", isa, 1);
    SweepKernels kernels;
    try {
      kernels = choose_kernels<double>(Basis::linear, static_cast<int>(bands));
    } catch (const InputError&) {
      continue;  // this machine does not have it
    }
    kernels.moments_to_directions(task());
    for (int d = 0; d < orbits * size; ++d)
      for (int row = 0; row < rows; ++row)
        for (std::size_t x = 0; x < length; ++x) {
          double sum = 0;
          for (int k = 0; k < moments; ++k) sum += factor(d, k) * moment(row, k, x);
          EXPECT_NEAR(value(d, row, x), sum, 1e-14) << isa;
        }
    const std::vector<double> before = moment_rows;
    kernels.directions_to_moments(task());
    for (int row = 0; row < rows; ++row)
      for (int k = 0; k < moments; ++k)
        for (std::size_t x = 0; x < length; ++x) {
          double sum = before[static_cast<std::size_t>(row * moments + k) * length + x];
          for (int d = 0; d < orbits * size; ++d) sum += factor(d, k) * value(d, row, x);
          EXPECT_NEAR(moment(row, k, x), sum, 1e-13) << isa;
        }
    moment_rows = before;
  }
}

INSTANTIATE_TEST_SUITE_P(OrbitSizes, MomentProduct, testing::Values(2, 8));

}  // namespace
}  // namespace etendue::moment_orbits_test
