// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <ostream>
#include <string>

#include "app/command/command_line.h"

namespace etendue {

/// Shows how a picture, or what else takes its time before or beside one, goes on: drawn over itself, or as
/// lines at intervals.
class PictureProgress {
 public:
  /// `style` must not be automatic; `name` is of what is made, "picture front".
  PictureProgress(ProgressStyle style, std::string name, std::ostream& out)
      : style_(style), name_(std::move(name)), out_(out) {}

  /// The share that is done, after so many seconds. The time that is left is reckoned from the first call on:
  /// what was prepared before takes none of it.
  void show(double share, double seconds);
  /// Ends the line that was drawn over.
  void finish();

 private:
  ProgressStyle style_;
  std::string name_;
  std::ostream& out_;
  double shown_at_ = 0;                              ///< [s]
  std::optional<std::array<double, 2>> first_ = {};  ///< share and seconds of the first call
  bool drawn_ = false;
};

}  // namespace etendue
