// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <ostream>
#include <string>

#include "app/command/command_line.h"

namespace etendue {

/// Shows how a picture goes on: drawn over itself, or as lines at intervals.
class PictureProgress {
 public:
  /// `style` must not be automatic.
  PictureProgress(ProgressStyle style, std::string name, std::ostream& out)
      : style_(style), name_(std::move(name)), out_(out) {}

  /// The share that is done, after so many seconds.
  void show(double share, double seconds);
  /// Ends the line that was drawn over.
  void finish();

 private:
  ProgressStyle style_;
  std::string name_;
  std::ostream& out_;
  double shown_at_ = 0;  ///< [s]
  bool drawn_ = false;
};

}  // namespace etendue
