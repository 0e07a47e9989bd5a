// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Every row of the table in docs/user/directions.md: what a set is, to the digits that are printed there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "solver/angular/harmonics/direction_report.h"
#include "solver/angular/sets/refinement.h"
#include "tests/support/checkout.h"

namespace etendue::direction_table_test {
namespace {

/// The cells of one row: set, order, directions, smallest … largest weight, degree, half range along x and y,
/// along z and random, row sum.
using Row = std::vector<std::string>;

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

std::vector<Row> documented_rows() {
  std::ifstream file(test::checkout("docs/user/directions.md"));
  std::vector<Row> rows;
  bool inside = false;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("## ")) inside = line == "## Measured";
    if (!inside || !line.starts_with("| ") || line.starts_with("| set")) continue;
    Row row;
    std::istringstream cells(line.substr(1));
    for (std::string cell; std::getline(cells, cell, '|');) row.push_back(trimmed(cell));
    rows.push_back(row);
  }
  return rows;
}

DirectionSet set_of(const Row& row) {
  const int order = std::stoi(row[1]);
  if (row[0] == "ldfe-sq, finer in 20° about z") return directions_ldfe_sq(order, {Vec3::UnitZ(), 20, 1});
  if (row[0] == "ldfe-sq, finer in 12° about (3, −5, 8)")
    return directions_ldfe_sq(order, {Vec3(0.3, -0.5, 0.8), 12, 2});
  return make_directions(row[0], order);
}

/// A printed number says what is meant to half of its last digit; "< a" says that it is less.
void expect_printed(const std::string& printed, double value, const Row& row) {
  if (printed.starts_with("< ")) {
    EXPECT_LT(value, std::stod(printed.substr(2))) << row[0] << " " << row[1];
    return;
  }
  const std::size_t exponent = printed.find('e'), point = printed.find('.');
  const std::size_t end = exponent == std::string::npos ? printed.size() : exponent;
  const double digits = point == std::string::npos ? 0 : static_cast<double>(end - point - 1);
  const double scale = exponent == std::string::npos ? 1 : std::stod("1" + printed.substr(exponent));
  EXPECT_NEAR(value, std::stod(printed), 0.51 * scale * std::pow(10, -digits)) << row[0] << " " << row[1];
}

class DocumentedSet : public testing::TestWithParam<Row> {};

TEST_P(DocumentedSet, IsWhatItsRowSays) {
  const Row& row = GetParam();
  ASSERT_EQ(row.size(), 9u);
  const DirectionSetReport report = report_directions(set_of(row));
  expect_printed(row[2], report.count, row);
  const std::string range = " … ";
  const std::size_t middle = row[3].find(range);
  expect_printed(row[3].substr(0, middle), report.smallest_weight, row);
  expect_printed(row[3].substr(middle + range.size()), report.largest_weight, row);
  EXPECT_LT(report.first_moment_error, 1e-12);
  EXPECT_LT(report.second_moment_error, 1e-12);
  expect_printed(row[4], report.degree, row);
  for (const std::size_t axis : {0, 1}) expect_printed(row[5], report.axis_half_range_error[axis], row);
  expect_printed(row[6], report.axis_half_range_error[2], row);
  expect_printed(row[7], report.half_range_error_rms, row);
  expect_printed(row[8], report.kernel_row_error, row);
}

std::string name_of(const testing::TestParamInfo<Row>& row) {
  std::string name = row.param[0] + "_" + row.param[1];
  std::erase_if(name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '_'; });
  return name;
}

TEST(DocumentedSets, AreAllThatTheOverviewPrints) {
  const std::vector<Row> rows = documented_rows();
  for (const std::string& name : direction_set_names())
    for (const int order : sample_orders(name, 5))
      EXPECT_EQ(std::ranges::count_if(
                    rows, [&](const Row& row) { return row[0] == name && row[1] == std::to_string(order); }),
                1)
          << name << " " << order;
}

INSTANTIATE_TEST_SUITE_P(Docs, DocumentedSet, testing::ValuesIn(documented_rows()), name_of);

TEST(DocumentedSets, HaveARowOfEveryFamily) {
  const std::vector<Row> rows = documented_rows();
  for (const std::string& name : direction_set_names())
    EXPECT_GE(std::ranges::count_if(rows, [&](const Row& row) { return row[0] == name; }), 3) << name;
}

}  // namespace
}  // namespace etendue::direction_table_test
