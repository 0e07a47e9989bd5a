// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/compare/method_answer.h"

namespace etendue {

/// Where a part of the error comes from.
enum class ErrorCause { cells, directions, patches, iteration, histories };
/// "cells", …
const char* name_of(ErrorCause cause);

/// A part of the error of each number.
struct ErrorPart {
  ErrorCause cause = ErrorCause::cells;
  std::string how;             ///< "on 1,270 cells"; of an error that is not known: why
  std::vector<double> errors;  ///< [number], in its unit; empty: not known
  double seconds = 0;          ///< that the repetition took
};

/// How far the numbers of a run are to be trusted.
struct ErrorEstimate {
  std::vector<AnswerNumber> numbers;  ///< with the whole error
  std::vector<ErrorPart> parts;
  bool is_coarse = false;  ///< the run itself gave a caution of its cells or directions
};

/// Returns the error of a number, as if its error were C h^order with the size h of cells or directions
/// (Richardson 1911): `change` is from one size to another, `ratio` the size of the repetition over that of
/// the run, above or below 1.
double error_of_change(double change, double ratio, double order);

/// Adds up the parts of each number in squares.
ErrorEstimate error_estimate(std::vector<AnswerNumber> numbers, std::vector<ErrorPart> parts, bool is_coarse);

/// The places of numbers that are at least a thousandth of the largest of their kind, by relative error, the
/// largest first: others are as good as zero.
std::vector<std::size_t> numbers_by_error(const ErrorEstimate& estimate);

/// Returns whether any part of the errors is known but for that of the iteration.
bool is_known(const ErrorEstimate& estimate);

/// Returns whether errors may be larger than stated: a part of them is not known, or cells or directions are
/// so coarse that coarser ones say little.
bool is_lower_bound(const ErrorEstimate& estimate);

/// How far to trust the numbers, in plain sentences, and what helps where errors exceed 2 %.
std::string verdict_of(const ErrorEstimate& estimate);

/// For people: the largest relative errors first, and the verdict.
std::string estimate_text(const ErrorEstimate& estimate);
/// where,band,quantity,value,error,relative and a column `error_CAUSE` for each part that is known.
std::string estimate_csv(const ErrorEstimate& estimate);
/// The entry `estimate` of summary.json.
std::string estimate_json(const ErrorEstimate& estimate);

}  // namespace etendue
