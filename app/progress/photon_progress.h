// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <ostream>
#include <string>

#include "app/request/command_line.h"
#include "solver/photons/solve/solve_photons.h"

namespace etendue {

/// Shows how many histories are walked, the error and the time that is left: drawn over itself, or as lines
/// at intervals.
class PhotonDisplay {
 public:
  /// `style` must not be automatic.
  PhotonDisplay(ProgressStyle style, std::ostream& out) : style_(style), out_(out) {}

  void show(const PhotonProgress& progress);
  /// Shows the last state where it was not shown yet, and ends the line that was drawn over.
  void finish();

 private:
  ProgressStyle style_;
  std::ostream& out_;
  std::optional<double> shown_at_ = {};  ///< [s]
  std::string waiting_;                  ///< the last state, where it was not shown
  bool drawn_ = false;
};

}  // namespace etendue
