// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <thread>
#include <utility>

#include "app/request/command_line.h"
#include "base/parallel/stage_observer.h"

namespace etendue {

/// Shows the progress of a stage of a run (a picture, lights, sensors): drawn over itself, or as lines at
/// intervals, the first after a second.
class StageProgress {
 public:
  /// `style` must not be automatic; `name` is of what is made, "picture front".
  StageProgress(ProgressStyle style, std::string name, std::ostream& out)
      : style_(style), name_(std::move(name)), out_(out) {}

  /// The share that is done, after so many seconds. The time that is left is computed from the first call on:
  /// what was prepared before takes none of it.
  void show(double share, double seconds);
  /// Of a stage that has not said yet how far it is: that it is under way, after so many seconds.
  void show_waiting(double seconds);
  /// Ends the line that was drawn over.
  void finish();

 private:
  bool is_due(double seconds) const;
  void print(const std::string& text, double seconds);

  ProgressStyle style_;
  std::string name_;
  std::ostream& out_;
  std::optional<double> shown_at_ = {};              ///< [s]
  std::optional<std::array<double, 2>> first_ = {};  ///< share and seconds of the first call
  bool drawn_ = false;
};

/// What a command needs to show its stages and to stop them.
struct StageDisplay {
  ProgressStyle style = ProgressStyle::none;  ///< not automatic
  std::ostream& out;
  std::function<bool()> interrupted;
};

/// A stage that begins now and is shown until this ends, by the time that it takes until it says which share
/// is done: nothing else may be written to the display's stream meanwhile but by this thread's observer.
/// Whatever the stage does, it may start processes: the thread that shows it waits while a process is copied.
/// After a signal a stage of a fraction of a second is still done, so that little is left out.
class ShownStage {
 public:
  ShownStage(const StageDisplay& display, std::string name);
  ~ShownStage();
  ShownStage(const ShownStage&) = delete;
  ShownStage& operator=(const ShownStage&) = delete;

  /// Shows shares, and stops the stage where the run is interrupted; this must outlive it.
  StageObserver observer();

 private:
  using Clock = std::chrono::steady_clock;
  StageProgress progress_;
  std::function<bool()> interrupted_;
  Clock::time_point begun_ = Clock::now();
  bool waits_ = false;  ///< the thread has begun
  bool says_share_ = false;
  bool ended_ = false;
  std::condition_variable ending_;
  std::thread waiting_;  ///< shows a stage that says nothing; none where nothing is shown
};

}  // namespace etendue
