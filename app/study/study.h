// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/case/case.h"
#include "app/request/command_line.h"
#include "app/study/richardson.h"

namespace etendue {

/// A number that a study follows from level to level.
struct StudyValue {
  std::string band;
  std::string quantity;
  double value = 0;
  std::optional<double> exact;  ///< what it should be, where that is known
};

/// What one level of a study came to.
struct LevelResult {
  int level = 0;  ///< from 1
  bool converged = false;
  int cells = 0;
  double size = 0;  ///< h = (volume/cells)^(1/3) [length]
  int directions = 0;
  AngularSpace space = AngularSpace::sphere;
  int sweeps = 0;       ///< of the slowest band
  double residual = 0;  ///< largest estimated relative error of the iteration
  double seconds = 0;
  double memory = 0;  ///< most that the program has taken meanwhile [bytes]
  std::vector<StudyValue> values;
};

struct StudyTrust;

/// A level that came to nothing, and why.
struct StudyFailure {
  int level = 0;
  std::string problem;
};

/// What an error is taken against.
enum class ErrorReference { exact, finest, richardson };
const char* name_of(ErrorReference reference);

/// A row of study.csv.
struct StudyRow {
  const LevelResult* level = nullptr;
  const StudyValue* value = nullptr;
  ErrorReference reference = ErrorReference::finest;
  std::optional<double> error;
  /// About how much of the value is the iteration's error; none of a balance, which is nothing else.
  std::optional<double> iteration;
  std::optional<double> order;  ///< from the level before
};

/// Where a quantity without an exact value goes, by its last three levels.
struct StudyLimit {
  const StudyValue* finest = nullptr;
  Extrapolation of;
};

/// "mesh", "directions" or "both".
const char* name_of(Refinement refinement);

/// What is refined: h, or the size of the directions, (4 pi/directions)^(1/2), in the plane 2 pi/directions.
double refined_size(const LevelResult& level, Refinement refinement);

/// The level with the most cells and the most directions, if it is there: of a grid all others may be.
const LevelResult* finest_of(const std::vector<LevelResult>& levels);

/// Errors and observed orders, quantity by quantity. The error of a fluence norm is the value itself; of
/// other quantities it is the distance from the exact value, or else from that of the finest level, which
/// then has none, or from the limit of the last three levels. Orders are against the refined size. Where both
/// are refined there are none: the larger error would hide the other. Nor is there one where the iteration is
/// seen, or from the levels that a limit was made of, since it would be the limit's own.
std::vector<StudyRow> study_rows(const std::vector<LevelResult>& levels, Refinement refinement,
                                 StudyReference against = StudyReference::finest);

/// Whether the error of the iteration is above a tenth of the row's error.
bool iteration_is_seen(const StudyRow& row);
bool is_same_quantity(const StudyRow& a, const StudyRow& b);
/// A relative norm of the error of the fluence.
bool is_norm(const std::string& quantity);

/// Limits of the quantities that have one, in the order of the rows.
std::vector<StudyLimit> study_limits(const std::vector<StudyRow>& rows, Refinement refinement);

std::string study_csv(const std::vector<StudyRow>& rows, Refinement refinement);
std::string study_json(const std::vector<StudyRow>& rows, Refinement refinement, const Case& input,
                       const std::vector<StudyFailure>& failures, const std::vector<StudyTrust>& trust);
/// What theory says of the orders of a family of exact solutions; empty where nothing is known.
std::string expectation_text(const Case& input, Refinement refinement);
/// The table for people, with what the errors are taken against and where the iteration disturbs them.
std::string study_text(const std::vector<StudyRow>& rows, const std::vector<LevelResult>& levels,
                       Refinement refinement, const std::vector<StudyFailure>& failures = {});

}  // namespace etendue
