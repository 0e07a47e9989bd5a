// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <utility>

namespace etendue {

/// Wish of the caller to end a sweep, asked by all threads and kept once it was expressed.
class StopSignal {
 public:
  /// `stops` may be empty: then nothing ends a sweep.
  explicit StopSignal(std::function<bool()> stops) : stops_(std::move(stops)) {}

  /// Asks the caller, unless the sweep has to end already.
  bool ask() {
    if (!is_set_ && stops_ && stops_()) is_set_ = true;
    return is_set_;
  }
  bool is_set() const { return is_set_; }

 private:
  std::function<bool()> stops_;
  std::atomic<bool> is_set_ = false;
};

}  // namespace etendue
