// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/accuracy/asked_numbers.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "app/compare/error_estimate.h"
#include "base/errors.h"

namespace etendue {
namespace {

/// "wall:floor" of "wall floor", "probe:axis:3" of "probe axis 3".
std::string quantity_of(const AnswerNumber& number) {
  std::string name = number.where;
  name[name.find(' ')] = ':';
  if (number.where.starts_with("probe ")) name[name.rfind(' ')] = ':';
  return name;
}

/// The names that quantities of this kind may have.
std::string names_like(std::string_view quantity, const std::vector<AnswerNumber>& numbers) {
  const std::string_view kind = quantity.substr(0, quantity.find(':') + 1);
  std::set<std::string> names;
  for (const AnswerNumber& number : numbers)
    if (const std::string name = quantity_of(number); name.starts_with(kind)) names.insert(name);
  return names.empty() ? "there is none" : fmt::format("use {}", fmt::join(names, ", "));
}

}  // namespace

bool is_of(const AnswerNumber& number, std::string_view quantity) {
  const std::string name = quantity_of(number);
  if (name == quantity) return true;
  return name.starts_with("probe:") && name.substr(0, name.rfind(':')) == quantity;
}

std::vector<std::size_t> asked_places(const AccuracyCase& accuracy,
                                      const std::vector<AnswerNumber>& numbers) {
  // Without names: all that are not as good as zero.
  if (accuracy.of.empty()) return numbers_by_error({.numbers = numbers, .parts = {}});
  std::vector<Fault> faults;
  std::set<std::size_t> places;
  for (const AskedQuantity& quantity : accuracy.of) {
    bool found = false;
    for (std::size_t i = 0; i < numbers.size(); ++i)
      if (is_of(numbers[i], quantity.name)) {
        found = true;
        places.insert(i);
      }
    if (!found)
      faults.push_back(fault_at(quantity.origin, fmt::format("\"{}\"", quantity.name),
                                "not there; " + names_like(quantity.name, numbers)));
  }
  if (!faults.empty()) throw InputError(std::move(faults));
  return {places.begin(), places.end()};
}

double allowed_error(const AccuracyCase& accuracy, const AnswerNumber& number) {
  return accuracy.absolute ? *accuracy.absolute : *accuracy.relative * std::abs(number.value);
}

}  // namespace etendue
