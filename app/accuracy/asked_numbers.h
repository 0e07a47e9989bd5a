// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "app/case/case.h"
#include "app/compare/kept_run.h"

namespace etendue {

/// Whether the name of a quantity in [accuracy] means this number.
bool is_of(const AnswerNumber& number, std::string_view quantity);

/// Places of the numbers that are to be accurate. Throws InputError where a name means none: with those that
/// there are.
std::vector<std::size_t> asked_places(const AccuracyCase& accuracy, const std::vector<AnswerNumber>& numbers);

/// The largest error that a number may have.
double allowed_error(const AccuracyCase& accuracy, const AnswerNumber& number);

}  // namespace etendue
