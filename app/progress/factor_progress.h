// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <ostream>
#include <string>
#include <utility>

#include "app/request/command_line.h"
#include "solver/radiosity/solve/solve_radiosity.h"

namespace etendue {

/// Shows how form factors are made, round by round, or the field in the cells: drawn over itself, or as lines
/// at intervals. What each round takes is said before it begins.
class FactorDisplay {
 public:
  /// `style` must not be automatic.
  FactorDisplay(ProgressStyle style, std::ostream& out, std::string what = "form factors")
      : style_(style), out_(out), what_(std::move(what)) {}

  /// A stage, so many seconds after the first.
  void show(const RadiosityStage& stage, double seconds);
  /// Ends the line that was drawn over.
  void finish();

 private:
  ProgressStyle style_;
  std::ostream& out_;
  std::string what_;
  double begun_at_ = 0, shown_at_ = 0;  ///< [s] this round, the last line
  bool drawn_ = false;
};

}  // namespace etendue
