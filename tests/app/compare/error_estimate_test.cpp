// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/compare/error_estimate.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace etendue::error_estimate_test {
namespace {

using nlohmann::json;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Two regions, of which one is as good as dark, and a wall.
std::vector<AnswerNumber> three_numbers() {
  return {{"region gas", "grey", "absorbed", 10, 0},
          {"region shade", "grey", "absorbed", 1e-3, 0},
          {"wall floor", "grey", "incoming", 2, 0}};
}

ErrorPart of_cells(std::vector<double> errors) {
  return {.cause = ErrorCause::cells, .how = "by 100 cells", .errors = std::move(errors)};
}
ErrorPart of_directions(std::vector<double> errors) {
  return {.cause = ErrorCause::directions, .how = "by 24 directions", .errors = std::move(errors)};
}

// Of e(h) = 3 h^2: e(1) = 3, e(2) = 12, e(1/2) = 3/4.
TEST(ErrorEstimate, FindsTheErrorOfAPowerOfTheSize) {
  EXPECT_DOUBLE_EQ(error_of_change(12 - 3, 2, 2), 3);
  EXPECT_DOUBLE_EQ(error_of_change(0.75 - 3, 0.5, 2), 3);
  EXPECT_DOUBLE_EQ(error_of_change(-5, 2, 1), 5);
}

TEST(ErrorEstimate, AddsItsPartsInSquares) {
  const ErrorEstimate estimate =
      error_estimate(three_numbers(), {of_cells({0.3, 0, 0.03}), of_directions({0.4, 0, 0.04})}, false);
  EXPECT_DOUBLE_EQ(estimate.numbers[0].error, 0.5);
  EXPECT_DOUBLE_EQ(estimate.numbers[2].error, 0.05);
  EXPECT_FALSE(is_lower_bound(estimate));
}

TEST(ErrorEstimate, LeavesOutNumbersThatAreAsGoodAsZero) {
  const ErrorEstimate estimate =
      error_estimate(three_numbers(), {of_cells({0.1, 1e-3, 0.1}), of_directions({0, 0, 0})}, false);
  EXPECT_EQ(numbers_by_error(estimate), (std::vector<std::size_t>{2, 0}));
}

TEST(ErrorEstimate, SaysWhatHelpsWhereErrorsExceedTwoPercent) {
  const ErrorEstimate small =
      error_estimate(three_numbers(), {of_cells({0.01, 0, 0.02}), of_directions({0.01, 0, 0.01})}, false);
  EXPECT_TRUE(has(verdict_of(small), "Trust half of these numbers to")) << verdict_of(small);
  EXPECT_FALSE(has(verdict_of(small), "max_volume")) << verdict_of(small);
  const ErrorEstimate by_cells =
      error_estimate(three_numbers(), {of_cells({1, 0, 0.02}), of_directions({0.01, 0, 0.01})}, false);
  EXPECT_TRUE(has(verdict_of(by_cells), "smaller ones in gas (mesh.max_volume)")) << verdict_of(by_cells);
  const ErrorEstimate by_directions =
      error_estimate(three_numbers(), {of_cells({0.1, 0, 0.02}), of_directions({1, 0, 0.01})}, false);
  EXPECT_TRUE(has(verdict_of(by_directions), "directions.order")) << verdict_of(by_directions);
}

TEST(ErrorEstimate, NamesTheLeastSureNumberInWords) {
  const std::vector<std::pair<AnswerNumber, std::string>> named = {
      {{"wall floor", "grey", "incoming", 2, 0}, "the power incoming at wall floor, band grey"},
      {{"region gas", "grey", "absorbed", 2, 0}, "the power absorbed by region gas, band grey"},
      {{"probe line 3", "grey", "fluence", 2, 0}, "the fluence at probe line 3, band grey"},
      {{"sensor eye", "photopic", "ugr", 2, 0}, "the ugr of sensor eye, band photopic"}};
  for (const auto& [number, words] : named) {
    const std::string verdict = verdict_of(error_estimate({number}, {of_cells({0.1})}, false));
    EXPECT_TRUE(has(verdict, "the least sure is " + words + ":")) << verdict;
  }
}

TEST(ErrorEstimate, NamesTheHistoriesThatHelp) {
  const auto verdict_for = [](const std::string& where) {
    const ErrorPart chance{.cause = ErrorCause::histories, .how = "", .errors = {1}};
    return verdict_of(error_estimate({{where, "grey", "fluence", 2, 0}}, {chance}, false));
  };
  EXPECT_TRUE(has(verdict_for("probe duct 1"), "(solve.probe_photons)")) << verdict_for("probe duct 1");
  EXPECT_TRUE(has(verdict_for("wall floor"), "(solve.photons)")) << verdict_for("wall floor");
}

TEST(ErrorEstimate, IsALowerBoundWherePartsAreNotKnownOrCellsAreCoarse) {
  ErrorPart unknown = of_directions({});
  unknown.how = "that takes about 60 s; --estimate finds it";
  const ErrorEstimate half = error_estimate(three_numbers(), {of_cells({0.1, 0, 0.02}), unknown}, false);
  EXPECT_TRUE(is_lower_bound(half));
  EXPECT_TRUE(has(verdict_of(half), "at least")) << verdict_of(half);
  EXPECT_TRUE(has(verdict_of(half), "The error of the directions is not in this (that takes about 60 s"))
      << verdict_of(half);
  const auto known = [](double error, bool coarse) {
    return error_estimate(three_numbers(), {of_cells({error, 0, 0}), of_directions({0, 0, 0})}, coarse);
  };
  EXPECT_FALSE(is_lower_bound(known(0.1, false)));
  EXPECT_TRUE(is_lower_bound(known(0.1, true)));
  EXPECT_TRUE(is_lower_bound(known(3, false)));  // 30 % are far from any order
  const ErrorEstimate nothing = error_estimate(three_numbers(), {unknown}, false);
  EXPECT_TRUE(has(verdict_of(nothing), "Nothing is known")) << verdict_of(nothing);
}

TEST(ErrorEstimate, OfPhotonsIsNoLowerBound) {
  const ErrorEstimate estimate = error_estimate(
      three_numbers(), {{.cause = ErrorCause::histories, .how = "1000 histories", .errors = {4, 0, 0.1}}},
      true);
  EXPECT_FALSE(is_lower_bound(estimate));
  EXPECT_TRUE(has(verdict_of(estimate), "solve.photons")) << verdict_of(estimate);
}

TEST(ErrorEstimate, IsWrittenAsTableAndAsJson) {
  const ErrorEstimate estimate =
      error_estimate(three_numbers(), {of_cells({0.3, 0, 0.03}), of_directions({0.4, 0, 0.04})}, false);
  EXPECT_TRUE(estimate_csv(estimate).starts_with(
      "where,band,quantity,value,error,relative,error_cells,error_directions\n"
      "region gas,grey,absorbed,10,0.5,0.05,0.3,0.4\n"))
      << estimate_csv(estimate);
  const json entry = json::parse(estimate_json(estimate));
  EXPECT_EQ(entry["lower_bound"], false);
  EXPECT_EQ(entry["numbers"].size(), 3U);
  EXPECT_EQ(entry["worst"]["where"], "region gas");
  EXPECT_EQ(entry["verdict"], verdict_of(estimate));
  EXPECT_TRUE(has(estimate_text(estimate), verdict_of(estimate)));
}

}  // namespace
}  // namespace etendue::error_estimate_test
