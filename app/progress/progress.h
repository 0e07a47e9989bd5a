// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <ostream>
#include <string>

#include "app/request/command_line.h"
#include "solver/solution/solve_observer.h"

namespace etendue {

/// Shows how an iteration goes on: as a bar that is drawn over itself, or as lines at intervals.
class ProgressDisplay {
 public:
  /// `style` must not be automatic.
  ProgressDisplay(ProgressStyle style, std::ostream& out) : style_(style), out_(out) {}

  void show(const SweepProgress& progress);
  /// Shows the last state where it was not shown yet, and ends the line of the bar.
  void finish();

 private:
  void draw_bar(const SweepProgress& progress, double residual);
  void print_line(const std::string& line);

  ProgressStyle style_;
  std::ostream& out_;
  double first_residual_ = 0;
  double shown_at_ = 0;  ///< [s] since the first sweep began
  std::string waiting_;  ///< the last line, where it was not printed
  bool bar_drawn_ = false;
};

/// The style that suits `out`: a bar on a terminal, else lines.
ProgressStyle resolved_style(ProgressStyle asked, const std::ostream& out);

}  // namespace etendue
