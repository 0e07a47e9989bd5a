// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/field_view.h"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

namespace etendue::field_view_test {
namespace {

/// 0, 1, 2, …: each value tells where it lies.
std::vector<double> numbers(std::size_t count) {
  std::vector<double> values(count);
  std::iota(values.begin(), values.end(), 0);
  return values;
}

TEST(FieldView, HasTheBandRunFastest) {
  const std::vector<double> values = numbers(3 * 4 * 3 * 5);
  const ConstCellVectors field(values, 5);
  EXPECT_EQ(field(CellIndex(0), 0, 0, 1), 1);
  EXPECT_EQ(field(CellIndex(0), 0, 1, 0), 5);
  EXPECT_EQ(field(CellIndex(0), 1, 0, 0), 15);
  EXPECT_EQ(field(CellIndex(1), 0, 0, 0), 60);
  EXPECT_EQ(field(2, 3, 2, 4), 179);
}

TEST(FieldView, WritesWhatItViews) {
  std::vector<double> values = numbers(2 * 3 * 2);
  const FaceField field(values, 2);
  field(FaceIndex(1), 2, 1) = -1;
  field(FaceIndex(1), 0, 0) += 10;
  EXPECT_EQ(values.back(), -1);
  EXPECT_EQ(values[6], 16);
  const BandTable table(values, 2);
  table(FaceIndex(2), 1) = -2;
  EXPECT_EQ(values[5], -2);
}

TEST(FieldView, TakesMeansOfOneBandOverTheCorners) {
  const std::vector<double> values = numbers(2 * 4 * 3);
  const ConstCellField field(values, 3);
  EXPECT_EQ(field.mean(CellIndex(0), 0), 4.5);
  EXPECT_EQ(field.mean(CellIndex(1), 2), 18.5);
  EXPECT_EQ(field.mean(1, 2), 18.5);
}

}  // namespace
}  // namespace etendue::field_view_test
