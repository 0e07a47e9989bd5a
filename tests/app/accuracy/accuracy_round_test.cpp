// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/accuracy/accuracy_round.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/accuracy/asked_numbers.h"
#include "base/errors.h"

namespace etendue::accuracy_round_test {
namespace {

AccuracyCase to_one_percent(std::vector<std::string> names) {
  AccuracyCase accuracy;
  accuracy.relative = 0.01;
  for (std::string& name : names) accuracy.of.push_back({std::move(name), {}});
  return accuracy;
}

double error_of(double cells, double directions) { return 40 * std::pow(cells, -2. / 3) + 5 / directions; }

KeptRun run_of(double cells, double directions) {
  const double error = error_of(cells, directions);
  KeptRun run;
  run.cells = cells;
  run.directions = directions;
  run.whole = true;
  run.numbers = {{"wall floor", "grey", "incoming", 2 * (1 + error)},
                 {"probe axis 0", "grey", "fluence", 1 - error},
                 {"probe axis 1", "grey", "fluence", 3 + error},
                 {"probe axis:1 0", "grey", "fluence", 7}};
  return run;
}

TEST(AccuracyRounds, AsksForWhatIsNotKnownFirst) {
  const AccuracyCase accuracy = to_one_percent({"wall:floor"});
  AccuracyRounds rounds(accuracy);
  rounds.add(run_of(1000, 96));
  EXPECT_FALSE(rounds.all().back().is_known);
  EXPECT_FALSE(rounds.all().back().is_accurate());
  EXPECT_EQ(rounds.next().what, Refined::cells);
  rounds.add(run_of(4000, 96));
  EXPECT_EQ(rounds.next().what, Refined::directions);
}

TEST(AccuracyRounds, FindsBothErrorsAndRefinesTheLarger) {
  const AccuracyCase accuracy = to_one_percent({"wall:floor"});
  AccuracyRounds rounds(accuracy);
  rounds.add(run_of(1000, 96));
  rounds.add(run_of(4000, 96));
  const AccuracyRound& last = rounds.add(run_of(4000, 384));
  ASSERT_EQ(last.estimate.parts.size(), 3U);
  // Three times the true ones, as each is known from one change.
  EXPECT_NEAR(last.estimate.parts[0].errors.at(0), 3 * 2 * 40 * std::pow(4000, -2. / 3), 1e-9);
  EXPECT_NEAR(last.estimate.parts[1].errors.at(0), 3 * 2 * 5. / 384, 1e-9);
  ASSERT_TRUE(last.worst);
  EXPECT_EQ(*last.worst, 0U);
  EXPECT_EQ(rounds.next().what, Refined::cells);
  EXPECT_DOUBLE_EQ(rounds.next().factor, 2);
}

TEST(AccuracyRounds, EndsWithErrorsThatAreTrue) {
  const AccuracyCase accuracy = to_one_percent({"wall:floor", "probe:axis"});
  AccuracyRounds rounds(accuracy);
  double cells = 1000, directions = 96;
  rounds.add(run_of(cells, directions));
  while (!rounds.all().back().is_accurate()) {
    const NextRefinement next = rounds.next();
    ASSERT_LT(rounds.all().size(), 20U);
    if (next.what == Refined::cells)
      cells *= std::pow(next.factor, 3);
    else
      directions *= next.factor * next.factor;
    rounds.add(run_of(cells, directions));
  }
  // Of "probe:axis" both points, and not the probe "axis:1".
  EXPECT_EQ(rounds.all().back().asked.size(), 3U);
  EXPECT_LE(error_of(cells, directions), 0.01);
  EXPECT_GT(error_of(cells, directions), 0.002) << "no more is refined than is needed";
}

TEST(AccuracyRounds, CellsThatStayTellNothing) {
  const AccuracyCase accuracy = to_one_percent({"wall:floor"});
  AccuracyRounds rounds(accuracy);
  rounds.add(run_of(1000, 96));
  const AccuracyRound& same = rounds.add(run_of(1100, 96));
  EXPECT_TRUE(same.estimate.parts.at(0).errors.empty());
}

TEST(AskedNumbers, AreThoseOfTheNames) {
  const std::vector<AnswerNumber> numbers = run_of(1000, 96).numbers;
  const auto places = [&](std::vector<std::string> names) {
    return asked_places(to_one_percent(std::move(names)), numbers);
  };
  EXPECT_EQ(places({"wall:floor"}), (std::vector<std::size_t>{0}));
  EXPECT_EQ(places({"probe:axis", "wall:floor"}), (std::vector<std::size_t>{0, 1, 2}));
  // A probe may have a name that ends as another does with an index.
  EXPECT_EQ(places({"probe:axis:1"}), (std::vector<std::size_t>{2, 3}));
  EXPECT_EQ(places({}).size(), 4U);
  try {
    places({"wall:roof"});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("not there; use wall:floor"), std::string::npos) << error.what();
  }
}

TEST(AskedNumbers, MayErrByAPartOrByAnAmount) {
  AccuracyCase accuracy = to_one_percent({});
  EXPECT_DOUBLE_EQ(allowed_error(accuracy, {"wall floor", "grey", "incoming", -2}), 0.02);
  accuracy.relative.reset();
  accuracy.absolute = 0.5;
  EXPECT_DOUBLE_EQ(allowed_error(accuracy, {"wall floor", "grey", "incoming", -2}), 0.5);
}

}  // namespace
}  // namespace etendue::accuracy_round_test
