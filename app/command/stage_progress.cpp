// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/command/stage_progress.h"

#include <fmt/format.h>

namespace etendue {
namespace {

// Often enough to see that it lives, seldom enough for a log and for a terminal.
constexpr double seconds_to_first_line = 1;
constexpr double seconds_between_lines = 5;
constexpr double seconds_between_drawings = 0.2;
// That a stage has after a signal, so that some of them together end within a second.
constexpr double seconds_of_grace = 0.25;

}  // namespace

void StageProgress::show(double share, double seconds) {
  if (style_ == ProgressStyle::none) return;
  if (!first_) first_ = {share, seconds};
  const auto [first_share, first_seconds] = *first_;
  if (share <= first_share) return;
  const bool draws = style_ == ProgressStyle::bar;
  const double interval = draws ? seconds_between_drawings : seconds_between_lines;
  if (seconds < (shown_at_ ? *shown_at_ + interval : draws ? interval : seconds_to_first_line)) return;
  shown_at_ = seconds;
  const double left = (seconds - first_seconds) * (1 - share) / (share - first_share);
  const std::string text = fmt::format("  {}: {:.0f} %, about {:.0f} s left", name_, 100 * share, left);
  if (draws)
    out_ << "\r" << text << "\x1b[K" << std::flush;
  else
    out_ << text << std::endl;
  drawn_ = draws;
}

void StageProgress::finish() {
  if (drawn_) out_ << "\r\x1b[K" << std::flush;
  drawn_ = false;
}

StageObserver ShownStage::observer() {
  return [this](double share) {
    const double seconds = std::chrono::duration<double>(Clock::now() - begun_).count();
    progress_.show(share, seconds);
    return seconds < seconds_of_grace || !interrupted_ || !interrupted_();
  };
}

}  // namespace etendue
