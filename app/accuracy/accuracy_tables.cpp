// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/accuracy/accuracy_tables.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "app/accuracy/asked_numbers.h"
#include "app/progress/text_table.h"
#include "app/write/csv/csv_field.h"

namespace etendue {
namespace {

using Json = nlohmann::ordered_json;

std::string percent(double part) { return fmt::format("{:.2g} %", 100 * part); }

/// An error for people, relative where that is what is asked for.
std::string error_text(double error, const AnswerNumber& one, const AccuracyCase& accuracy) {
  return accuracy.relative && one.value != 0 ? percent(error / std::abs(one.value))
                                             : fmt::format("{:.2g}", error);
}

std::string allowed_text(const AccuracyCase& accuracy) {
  return accuracy.relative ? fmt::format("{:.3g} %", 100 * *accuracy.relative)
                           : fmt::format("{:.3g}", *accuracy.absolute);
}

/// Of one number, where it is known.
std::string part_csv(const ErrorPart& part, std::size_t number) {
  return part.errors.empty() ? "" : fmt::format("{}", part.errors[number]);
}

Json round_json(const AccuracyRound& round) {
  Json json = {{"cells", round.run.cells},
               {"directions", round.run.directions},
               {"sweeps", round.run.sweeps},
               {"seconds", round.run.seconds}};
  if (round.worst) {
    const AnswerNumber& worst = round.estimate.numbers[*round.worst];
    json["worst"] = {{"where", worst.where},
                     {"band", worst.band},
                     {"quantity", worst.quantity},
                     {"value", worst.value},
                     {"error", round.is_known ? Json(worst.error) : Json()}};
  }
  return json;
}

}  // namespace

std::string goal_text(const AccuracyCase& accuracy) {
  return fmt::format("accuracy: {} of {}, within {:.3g} minutes\n", allowed_text(accuracy),
                     accuracy.of.empty()       ? "all probes, sensors, powers of walls and regions"
                     : accuracy.of.size() == 1 ? accuracy.of.front().name
                                               : fmt::format("{} quantities", accuracy.of.size()),
                     accuracy.minutes);
}

std::string round_heading() {
  return fmt::format("  {:>5}  {:>9}  {:>10}  {:>6}  {:>8}  {:>8}  {:>8}  {:>13}  {}\n", "round", "cells",
                     "directions", "sweeps", "seconds", "error", "by cells", "by directions",
                     "least accurate");
}

std::string round_line(const AccuracyRound& round, int index, const AccuracyCase& accuracy) {
  std::string line = fmt::format("  {:>5}  {:>9.0f}  {:>10.0f}  {:>6}  {:>8.1f}", index, round.run.cells,
                                 round.run.directions, round.run.sweeps, round.run.seconds);
  if (!round.worst) return line + "\n";
  const AnswerNumber& worst = round.estimate.numbers[*round.worst];
  const auto part = [&](std::size_t k) {
    const ErrorPart& one = round.estimate.parts[k];
    return one.errors.empty() ? "?" : error_text(one.errors[*round.worst], worst, accuracy);
  };
  return line + fmt::format("  {:>8}  {:>8}  {:>13}  {} of {}, band {}: {}\n",
                            round.is_known ? error_text(worst.error, worst, accuracy) : "?", part(0), part(1),
                            worst.quantity, worst.where, worst.band, number(worst.value));
}

std::string outcome_text(const AccuracyOutcome& outcome, const AccuracyRound& last,
                         const AccuracyCase& accuracy) {
  if (outcome.reached)
    return fmt::format("accuracy of {} reached for {} {} in {:.1f} s\n", allowed_text(accuracy),
                       last.asked.size(), last.asked.size() == 1 ? "number" : "numbers", outcome.seconds);
  std::size_t inside = 0;
  for (const std::size_t i : last.asked) {
    const AnswerNumber& one = last.estimate.numbers[i];
    if (one.error <= allowed_error(accuracy, one)) ++inside;
  }
  if (!last.is_known) inside = 0;
  return fmt::format("accuracy of {} not reached: {} of {} numbers have it; {}\n", allowed_text(accuracy),
                     inside, last.asked.size(), outcome.why);
}

std::string accuracy_csv(const std::vector<AccuracyRound>& rounds, const AccuracyCase& accuracy) {
  std::string text =
      "round,cells,directions,sweeps,seconds,where,band,quantity,value,error,error_cells,error_directions,"
      "error_iteration,allowed\n";
  for (std::size_t k = 0; k < rounds.size(); ++k)
    for (const std::size_t i : rounds[k].asked) {
      const AccuracyRound& round = rounds[k];
      const AnswerNumber& one = round.estimate.numbers[i];
      fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", k + 1,
                     round.run.cells, round.run.directions, round.run.sweeps, round.run.seconds,
                     csv_field(one.where), csv_field(one.band), one.quantity, one.value,
                     round.is_known ? fmt::format("{}", one.error) : "", part_csv(round.estimate.parts[0], i),
                     part_csv(round.estimate.parts[1], i), part_csv(round.estimate.parts[2], i),
                     allowed_error(accuracy, one));
    }
  return text;
}

std::string accuracy_json(const AccuracyOutcome& outcome, const std::vector<AccuracyRound>& rounds,
                          const AccuracyCase& accuracy) {
  Json json = {{"reached", outcome.reached},
               {"relative", accuracy.relative ? Json(*accuracy.relative) : Json()},
               {"absolute", accuracy.absolute ? Json(*accuracy.absolute) : Json()},
               {"seconds", outcome.seconds}};
  if (!outcome.reached) json["why"] = outcome.why;
  json["rounds"] = Json::array();
  for (const AccuracyRound& round : rounds) json["rounds"].push_back(round_json(round));
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace etendue
