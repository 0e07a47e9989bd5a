// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/case/case.h"
#include "app/command/command_line.h"

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
  double memory = 0;  ///< most that the program has taken up to its end [bytes]
  std::vector<StudyValue> values;
};

/// A row of study.csv.
struct StudyRow {
  const LevelResult* level = nullptr;
  const StudyValue* value = nullptr;
  std::optional<double> error;
  std::optional<double> order;  ///< from the level before
};

/// "mesh", "directions" or "both".
const char* name_of(Refinement refinement);

/// Errors and observed orders, quantity by quantity. The error of a fluence norm is the value itself; of
/// other quantities it is the distance from the exact value, or else from that of the finest level, which
/// then has none. Orders are against h, or against the size of the directions, (4 pi/directions)^(1/2)
/// (in the plane 2 pi/directions). Where both are refined there are none: the larger error would hide the
/// other.
std::vector<StudyRow> study_rows(const std::vector<LevelResult>& levels, Refinement refinement);

std::string study_csv(const std::vector<StudyRow>& rows, Refinement refinement);
std::string study_json(const std::vector<StudyRow>& rows, Refinement refinement, const Case& input);
/// What theory says of the orders of a family of exact solutions; empty where nothing is known.
std::string expectation_text(const Case& input, Refinement refinement);
/// The table for people, with what the errors are taken against and where the iteration disturbs them.
std::string study_text(const std::vector<StudyRow>& rows, const std::vector<LevelResult>& levels,
                       Refinement refinement);

}  // namespace etendue
