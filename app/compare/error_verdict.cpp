// SPDX-License-Identifier: AGPL-3.0-or-later
//
// What a person reads of an estimate of errors.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "app/compare/error_estimate.h"
#include "app/progress/text_table.h"

namespace etendue {
namespace {

constexpr std::size_t longest_verdict = 12;
/// Errors above which the verdict names a remedy.
constexpr double tolerable = 0.02;
/// Errors above which a change says little of how they fall with the size of cells and directions.
constexpr double beyond_an_order = 0.2;

double part_of_value(double error, const AnswerNumber& number) { return error / std::abs(number.value); }

std::string percent(double part) { return fmt::format("{:.2g} %", 100 * part); }

/// "power absorbed by region skin", "power incoming at wall floor", "fluence at probe line 3".
std::string name_of(const AnswerNumber& number) {
  std::string what = number.quantity + " of ";
  if (number.where.starts_with("region ")) what = "power absorbed by ";
  if (number.where.starts_with("wall ")) what = "power incoming at ";
  if (number.where.starts_with("probe ")) what = number.quantity + " at ";
  return fmt::format("{}{}, band {}", what, number.where, number.band);
}

/// The part that errs most in a number; null where none is known.
const ErrorPart* largest_part(const ErrorEstimate& estimate, std::size_t number) {
  const ErrorPart* largest = nullptr;
  for (const ErrorPart& part : estimate.parts)
    if (!part.errors.empty() && (largest == nullptr || part.errors[number] > largest->errors[number]))
      largest = &part;
  return largest;
}

std::string remedy_for(ErrorCause cause, const AnswerNumber& number) {
  const bool of_region = number.where.starts_with("region ");
  switch (cause) {
    case ErrorCause::cells:
      return fmt::format(
          "Most of it is due to the cells: use smaller ones {} (mesh.max_volume), or solve.method = "
          "\"photons\".",
          of_region ? "in " + number.where.substr(7) : "around " + number.where);
    case ErrorCause::directions:
      return "Most of it is due to the directions: use more of them (directions.order; of lamps and beams "
             "directions.first_collided), or solve.method = \"photons\".";
    case ErrorCause::patches:
      return "Use smaller patches (radiosity.patch_size).";
    case ErrorCause::iteration:
      return "Most of it is due to the iteration: use a smaller solve.tolerance.";
    case ErrorCause::histories:
      break;
  }
  return fmt::format("Use more histories ({}); four times as many halve it.",
                     number.where.starts_with("probe ") ? "solve.probe_photons" : "solve.photons");
}

std::string unknown_parts(const ErrorEstimate& estimate) {
  std::string text;
  for (const ErrorPart& part : estimate.parts)
    if (part.errors.empty())
      text += fmt::format(" The error of the {} is not in this ({}).", name_of(part.cause), part.how);
  return text;
}

}  // namespace

bool is_lower_bound(const ErrorEstimate& estimate) {
  const std::vector<std::size_t> places = numbers_by_error(estimate);
  const bool large = !places.empty() && part_of_value(estimate.numbers[places.front()].error,
                                                      estimate.numbers[places.front()]) > beyond_an_order;
  const bool by_chance = std::ranges::all_of(
      estimate.parts, [](const ErrorPart& part) { return part.cause == ErrorCause::histories; });
  return std::ranges::any_of(estimate.parts, [](const ErrorPart& part) { return part.errors.empty(); }) ||
         (!by_chance && (large || estimate.is_coarse));
}

std::string verdict_of(const ErrorEstimate& estimate) {
  const std::vector<std::size_t> places = numbers_by_error(estimate);
  if (places.empty() || !is_known(estimate))
    return "Nothing is known of the errors of these numbers." + unknown_parts(estimate);
  const std::size_t worst = places.front();
  const AnswerNumber& number = estimate.numbers[worst];
  const double error = part_of_value(number.error, number);
  const double typical = part_of_value(estimate.numbers[places[places.size() / 2]].error,
                                       estimate.numbers[places[places.size() / 2]]);
  const bool bound = is_lower_bound(estimate);
  std::string text =
      fmt::format("{} {}; the least sure is the {}: {} {}.",
                  bound ? "These numbers may be off by more than is stated here: half of them by at least"
                        : "Trust half of these numbers to",
                  percent(typical), name_of(number), bound ? "at least" : "about", percent(error));
  if (bound && estimate.is_coarse)
    text += " The cells or directions are so coarse (see the caution) that coarser ones tell little.";
  text += unknown_parts(estimate);
  if (error > tolerable) text += " " + remedy_for(largest_part(estimate, worst)->cause, number);
  return text;
}

std::string estimate_text(const ErrorEstimate& estimate) {
  if (!is_known(estimate)) return "\n" + verdict_of(estimate) + "\n";
  std::string text = "\nhow far to trust the numbers";
  for (const ErrorPart& part : estimate.parts)
    if (!part.errors.empty())
      fmt::format_to(std::back_inserter(text), "; error of the {}: {}", name_of(part.cause), part.how);
  text += "\n";
  std::vector<std::string> names = {"", "band", "quantity", "value", "error", "relative"};
  std::vector<Align> alignment = {Align::left,  Align::left,  Align::left,
                                  Align::right, Align::right, Align::right};
  for (const ErrorPart& part : estimate.parts) {
    if (part.errors.empty()) continue;
    names.push_back(std::string("by ") + name_of(part.cause));
    alignment.push_back(Align::right);
  }
  TextTable table(names, alignment);
  const std::vector<std::size_t> places = numbers_by_error(estimate);
  for (std::size_t k = 0; k < std::min(places.size(), longest_verdict); ++k) {
    const AnswerNumber& one = estimate.numbers[places[k]];
    std::vector<std::string> row = {one.where,
                                    one.band,
                                    one.quantity,
                                    number(one.value),
                                    fmt::format("{:.1e}", one.error),
                                    percent(part_of_value(one.error, one))};
    for (const ErrorPart& part : estimate.parts)
      if (!part.errors.empty()) row.push_back(percent(part_of_value(part.errors[places[k]], one)));
    table.add_row(std::move(row));
  }
  if (!table.empty()) text += table.text();
  if (places.size() > longest_verdict)
    fmt::format_to(std::back_inserter(text), "  {} more, each at most {}: estimate.csv has them\n",
                   places.size() - longest_verdict,
                   percent(part_of_value(estimate.numbers[places[longest_verdict]].error,
                                         estimate.numbers[places[longest_verdict]])));
  return text + verdict_of(estimate) + "\n";
}

}  // namespace etendue
