// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/accuracy/accuracy_round.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/accuracy/asked_numbers.h"

namespace etendue {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
/// Between the sizes of two rounds.
constexpr double least_factor = 1.3, largest_factor = 2;
/// Of a first refinement, which tells the error of a part.
constexpr double first_factor = 1.6;
/// Of the error beyond what would just do: the other part needs some of what is allowed, and estimates err.
constexpr double reserve = 1.5;

/// Of the parts in an estimate.
constexpr std::size_t place_of_cells = 0, place_of_directions = 1, place_of_iteration = 2;
constexpr std::array both = {Refined::cells, Refined::directions};

double order_of(Refined what, const KeptRun& run) { return what == Refined::cells ? run.order_of_cells : 2; }

ErrorPart part_of(Refined what, std::vector<double> errors, const std::vector<AccuracyRound>& before) {
  ErrorPart part{.cause = what == Refined::cells ? ErrorCause::cells : ErrorCause::directions,
                 .how = "not known yet",
                 .errors = std::move(errors)};
  if (!part.errors.empty())
    part.how = fmt::format("by the rounds before, from {:.0f} {} on",
                           what == Refined::cells ? before.front().run.cells : before.front().run.directions,
                           name_of(part.cause));
  return part;
}

/// What the iteration leaves, and rays with it.
ErrorPart part_of_iteration(const KeptRun& run) {
  ErrorPart part{.cause = ErrorCause::iteration,
                 .how = fmt::format("solve.tolerance = {:g}", run.tolerance),
                 .errors = {}};
  for (const AnswerNumber& number : run.numbers)
    part.errors.push_back(run.tolerance * std::abs(number.value));
  return part;
}

/// With errors that are the sums of their parts: both may have the same sign, and these have to hold.
ErrorEstimate sum_of_parts(ErrorEstimate estimate) {
  for (std::size_t i = 0; i < estimate.numbers.size(); ++i) {
    estimate.numbers[i].error = 0;
    for (const ErrorPart& part : estimate.parts)
      if (!part.errors.empty()) estimate.numbers[i].error += part.errors[i];
  }
  return estimate;
}

/// Over what is allowed. What is no number has no accuracy.
double excess_of_error(double error, double allowed) {
  if (error == 0) return 0;
  return std::isnan(error / allowed) ? infinite : error / allowed;
}

}  // namespace

double size_of(Refined what, const KeptRun& run) {
  if (what == Refined::cells) return run.is_flat ? std::sqrt(1 / run.cells) : std::cbrt(1 / run.cells);
  return run.is_flat ? 1 / run.directions : std::sqrt(1 / run.directions);
}

std::vector<double> AccuracyRounds::errors_of(Refined what, const KeptRun& run) const {
  if (!history(what).is_known()) return {};
  return history(what).errors(size_of(what, run), order_of(what, run));
}

const AccuracyRound& AccuracyRounds::add(KeptRun run) {
  if (!rounds_.empty()) {
    const KeptRun& last = rounds_.back().run;
    const bool of_cells = last.directions == run.directions;
    const Refined what = of_cells ? Refined::cells : Refined::directions;
    RefinementChange change{size_of(what, last), size_of(what, run), {}};
    for (std::size_t i = 0; i < run.numbers.size(); ++i)
      change.changes.push_back(change_of(last.numbers[i], run.numbers[i]));
    history(what).add(std::move(change));
  }
  std::vector<ErrorPart> parts;
  for (const Refined what : both) parts.push_back(part_of(what, errors_of(what, run), rounds_));
  parts.push_back(part_of_iteration(run));
  AccuracyRound round;
  round.estimate = sum_of_parts(error_estimate(run.numbers, std::move(parts), run.is_coarse));
  round.asked = asked_places(accuracy_, run.numbers);
  round.run = std::move(run);
  for (const std::size_t i : round.asked) {
    const AnswerNumber& number = round.estimate.numbers[i];
    const double excess = excess_of_error(number.error, allowed_error(accuracy_, number));
    if (round.worst && excess <= round.excess) continue;
    round.worst = i;
    round.excess = excess;
  }
  round.is_known =
      std::ranges::none_of(round.estimate.parts, [](const ErrorPart& part) { return part.errors.empty(); });
  rounds_.push_back(std::move(round));
  return rounds_.back();
}

double AccuracyRounds::excess_of(std::size_t which) const {
  const AccuracyRound& round = rounds_.back();
  const ErrorPart& part = round.estimate.parts[which];
  if (part.errors.empty()) return infinite;
  double excess = 0;
  for (const std::size_t i : round.asked)
    excess = std::max(excess,
                      excess_of_error(part.errors[i], allowed_error(accuracy_, round.estimate.numbers[i])));
  return excess;
}

double AccuracyRounds::excess_of_iteration() const { return excess_of(place_of_iteration); }

NextRefinement AccuracyRounds::next() const {
  const double of_cells = excess_of(place_of_cells), of_directions = excess_of(place_of_directions);
  const Refined what = of_directions > of_cells ? Refined::directions : Refined::cells;
  const double excess = std::max(of_cells, of_directions);
  const double wanted = std::pow(reserve * excess, 1 / order_of(what, rounds_.back().run));
  if (!history(what).is_known()) return {what, first_factor};
  return {what, std::clamp(wanted, least_factor, largest_factor)};
}

}  // namespace etendue
