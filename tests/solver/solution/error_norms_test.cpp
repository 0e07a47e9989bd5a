// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/solution/error_norms.h"

#include <gtest/gtest.h>

namespace etendue::error_norms_test {
namespace {

TEST(ErrorNorms, AreRelativeToTheReference) {
  ErrorNorms norms;
  norms.add(3, 2, 1);
  norms.add(0, -4, 0.25);
  EXPECT_DOUBLE_EQ(norms.l2(), std::sqrt(5.0 / 8));
  EXPECT_EQ(norms.maximum(), 1);
}

TEST(ErrorNorms, CountAPointWithoutWeightInTheMaximumAlone) {
  ErrorNorms norms;
  norms.add(1, 1, 1);
  norms.add(5, 2, 0);
  EXPECT_EQ(norms.l2(), 0);
  EXPECT_EQ(norms.maximum(), 1.5);
}

TEST(ErrorNorms, AreThoseOfAllParts) {
  ErrorNorms whole, first, second;
  for (const double value : {1.0, 4.0}) {
    whole.add(value, 2, 0.5);
    first.add(value, 2, 0.5);
  }
  whole.add(-7, -6, 2);
  second.add(-7, -6, 2);
  first.add(second);
  EXPECT_EQ(first.l2(), whole.l2());
  EXPECT_EQ(first.maximum(), whole.maximum());
}

TEST(ErrorNorms, OfADarkReferenceAreNotDivided) {
  ErrorNorms norms;
  norms.add(3, 0, 4);
  EXPECT_EQ(norms.l2(), 6);
  EXPECT_EQ(norms.maximum(), 3);
}

}  // namespace
}  // namespace etendue::error_norms_test
