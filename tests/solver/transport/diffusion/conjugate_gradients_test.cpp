// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/diffusion/conjugate_gradients.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace etendue::conjugate_gradients_test {
namespace {

/// -u'' on 100 points.
void laplacian(std::span<const double> x, std::span<double> y) {
  for (std::size_t i = 0; i < x.size(); ++i)
    y[i] = 2 * x[i] - (i > 0 ? x[i - 1] : 0) - (i + 1 < x.size() ? x[i + 1] : 0);
}
void identity(std::span<const double> x, std::span<double> y) { std::copy(x.begin(), x.end(), y.begin()); }

TEST(ConjugateGradients, EndAfterAsManyStepsAsThereAreUnknowns) {
  std::vector<double> right(100), x(100), image(100);
  for (std::size_t i = 0; i < right.size(); ++i) right[i] = std::sin(static_cast<double>(i * i));
  EXPECT_LE(conjugate_gradients(laplacian, identity, right, x, {1e-12, 200, 1}), 101);
  laplacian(x, image);
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(image[i], right[i], 1e-9);
}

TEST(ConjugateGradients, NothingAskedIsNothingDone) {
  const std::vector<double> right(10, 0);
  std::vector<double> x(10, 7);
  EXPECT_EQ(conjugate_gradients(laplacian, identity, right, x, {}), 0);
  EXPECT_EQ(x, right);
}

TEST(OrderedDot, SameBitsForAnyNumberOfThreads) {
  std::vector<double> a(50'000), b(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    a[i] = std::sin(static_cast<double>(i));
    b[i] = std::exp(std::cos(static_cast<double>(3 * i)));
  }
  const double one = ordered_dot(a, b, 1);
  for (const int threads : {2, 3, 4}) EXPECT_EQ(ordered_dot(a, b, threads), one);
}

}  // namespace
}  // namespace etendue::conjugate_gradients_test
