// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/compare/error_estimate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>

#include "app/write/csv/csv_field.h"

namespace etendue {
namespace {

/// Of the largest number of its kind; what is less is as good as zero.
constexpr double negligible = 1e-3;

double relative_error(const AnswerNumber& number) {
  const double size = std::abs(number.value);
  return size > 0 ? number.error / size : number.error > 0 ? HUGE_VAL : 0.0;
}

/// Numbers that may be compared: "region fluence green" of "region smoke".
std::string kind_of(const AnswerNumber& number) {
  return number.where.substr(0, number.where.find(' ')) + " " + number.quantity;
}

}  // namespace

const char* name_of(ErrorCause cause) {
  switch (cause) {
    case ErrorCause::cells:
      return "cells";
    case ErrorCause::directions:
      return "directions";
    case ErrorCause::patches:
      return "patches";
    case ErrorCause::iteration:
      return "iteration";
    case ErrorCause::histories:
      break;
  }
  return "histories";
}

// e(h) = C h^p: change = C h^p |ratio^p - 1|.
double error_of_change(double change, double ratio, double order) {
  return std::abs(change) / std::abs(std::pow(ratio, order) - 1);
}

ErrorEstimate error_estimate(std::vector<AnswerNumber> numbers, std::vector<ErrorPart> parts,
                             bool is_coarse) {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    numbers[i].error = 0;
    for (const ErrorPart& part : parts)
      if (!part.errors.empty()) numbers[i].error = std::hypot(numbers[i].error, part.errors[i]);
  }
  return {std::move(numbers), std::move(parts), is_coarse};
}

std::vector<std::size_t> numbers_by_error(const ErrorEstimate& estimate) {
  std::map<std::string, double> largest;
  for (const AnswerNumber& number : estimate.numbers) {
    double& size = largest[kind_of(number)];
    size = std::max(size, std::abs(number.value));
  }
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < estimate.numbers.size(); ++i) {
    const AnswerNumber& number = estimate.numbers[i];
    if (std::abs(number.value) > negligible * largest[kind_of(number)]) places.push_back(i);
  }
  std::ranges::stable_sort(places, std::greater(),
                           [&](std::size_t i) { return relative_error(estimate.numbers[i]); });
  return places;
}

bool is_known(const ErrorEstimate& estimate) {
  return std::ranges::any_of(estimate.parts, [](const ErrorPart& part) {
    return part.cause != ErrorCause::iteration && !part.errors.empty();
  });
}

std::string estimate_csv(const ErrorEstimate& estimate) {
  std::string text = "where,band,quantity,value,error,relative";
  for (const ErrorPart& part : estimate.parts)
    if (!part.errors.empty()) text += fmt::format(",error_{}", name_of(part.cause));
  text += "\n";
  for (std::size_t i = 0; i < estimate.numbers.size(); ++i) {
    const AnswerNumber& number = estimate.numbers[i];
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{}", csv_field(number.where),
                   csv_field(number.band), number.quantity, number.value, number.error,
                   relative_error(number));
    for (const ErrorPart& part : estimate.parts)
      if (!part.errors.empty()) fmt::format_to(std::back_inserter(text), ",{}", part.errors[i]);
    text += "\n";
  }
  return text;
}

std::string estimate_json(const ErrorEstimate& estimate) {
  using Json = nlohmann::ordered_json;
  Json parts = Json::array(), numbers = Json::array();
  for (const ErrorPart& part : estimate.parts)
    parts.push_back({{"cause", name_of(part.cause)},
                     {"known", !part.errors.empty()},
                     {"how", part.how},
                     {"seconds", part.seconds}});
  for (const AnswerNumber& number : estimate.numbers) {
    const double part = relative_error(number);
    numbers.push_back({{"where", number.where},
                       {"band", number.band},
                       {"quantity", number.quantity},
                       {"value", number.value},
                       {"error", number.error},
                       {"relative", std::isfinite(part) ? Json(part) : Json()}});
  }
  const std::vector<std::size_t> places = numbers_by_error(estimate);
  const Json json = {{"verdict", verdict_of(estimate)},
                     {"lower_bound", is_lower_bound(estimate)},
                     {"worst", places.empty() ? Json() : numbers[places.front()]},
                     {"parts", parts},
                     {"numbers", numbers}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace etendue
