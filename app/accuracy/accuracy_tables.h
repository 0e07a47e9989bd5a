// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/accuracy/accuracy_round.h"

namespace etendue {

/// How the rounds ended.
struct AccuracyOutcome {
  bool reached = false;
  std::string why = {};  ///< it ended without that; a sentence without its stop
  double seconds = 0;    ///< of all rounds
};

/// What is asked for, as a line.
std::string goal_text(const AccuracyCase& accuracy);

/// Names of the columns that round_line() fills.
std::string round_heading();
/// One line for people: what the round had, and the number that is the least accurate.
std::string round_line(const AccuracyRound& round, int index, const AccuracyCase& accuracy);

/// What came of it, for people.
std::string outcome_text(const AccuracyOutcome& outcome, const AccuracyRound& last,
                         const AccuracyCase& accuracy);

/// round,cells,directions,sweeps,seconds,where,band,quantity,value,error,error_cells,error_directions,error_iteration,allowed:
/// a row for each round and each number that is to be accurate; errors that are not known are empty.
std::string accuracy_csv(const std::vector<AccuracyRound>& rounds, const AccuracyCase& accuracy);

/// The entry `accuracy` of summary.json.
std::string accuracy_json(const AccuracyOutcome& outcome, const std::vector<AccuracyRound>& rounds,
                          const AccuracyCase& accuracy);

}  // namespace etendue
