// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <mutex>
#include <utility>

namespace etendue {

/// Called now and then with the share of a stage that is done, from 0 to 1; false stops the stage.
using StageObserver = std::function<bool(double share)>;

/// Counts the parts of a stage that threads have done and asks an observer, some twenty times a second and at
/// the end. No more than one thread is in the observer at a time, and no other waits for it.
class StageCounter {
 public:
  /// Without an observer the stage continues to its end.
  StageCounter(std::size_t parts, StageObserver observer) : parts_(parts), observer_(std::move(observer)) {}

  /// Adds parts that are done. Returns whether the stage continues.
  bool add(std::size_t parts = 1) {
    const std::size_t done = done_.fetch_add(parts) + parts;
    if (observer_ && !stopped_) ask(done);
    return !stopped_;
  }
  bool stopped() const { return stopped_; }
  std::size_t done() const { return done_; }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds interval{50};

  void ask(std::size_t done) {
    std::unique_lock<std::mutex> lock(asking_, std::defer_lock);
    if (done >= parts_)
      lock.lock();
    else if (!lock.try_lock())
      return;
    const Clock::time_point now = Clock::now();
    if (done < parts_ && now < asked_ + interval) return;
    asked_ = now;
    const double share = parts_ > 0 ? static_cast<double>(done) / static_cast<double>(parts_) : 1;
    if (!observer_(share < 1 ? share : 1)) stopped_ = true;
  }

  std::size_t parts_;
  StageObserver observer_;
  std::atomic<std::size_t> done_ = 0;
  std::atomic<bool> stopped_ = false;
  std::mutex asking_;
  Clock::time_point asked_ = {};
};

}  // namespace etendue
