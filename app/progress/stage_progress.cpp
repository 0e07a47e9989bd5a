// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/progress/stage_progress.h"

#include <fmt/format.h>
#include <pthread.h>

#include <mutex>

#include "app/progress/display_times.h"

namespace etendue {
namespace {

// That a stage has after a signal, so that some of them together end within a second.
constexpr double seconds_of_grace = 0.25;

// Guards what is shown, and is held while a process is copied (fork): a copy of a process in which another
// thread allocates memory just then may wait for ever for that thread, which the copy does not have.
std::mutex showing;

void hold_while_copied() {
  static const int registered =
      pthread_atfork([] { showing.lock(); }, [] { showing.unlock(); }, [] { showing.unlock(); });
  static_cast<void>(registered);
}

}  // namespace

bool StageProgress::is_due(double seconds) const {
  if (style_ == ProgressStyle::none) return false;
  const bool draws = style_ == ProgressStyle::bar;
  const double interval = draws ? seconds_between_drawings : seconds_between_lines;
  return seconds >= (shown_at_ ? *shown_at_ + interval : draws ? interval : seconds_to_first_line);
}

void StageProgress::print(const std::string& text, double seconds) {
  shown_at_ = seconds;
  drawn_ = style_ == ProgressStyle::bar;
  if (drawn_)
    out_ << "\r" << text << "\x1b[K" << std::flush;
  else
    out_ << text << std::endl;
}

void StageProgress::show(double share, double seconds) {
  if (style_ == ProgressStyle::none) return;
  if (!first_) first_ = {share, seconds};
  const auto [first_share, first_seconds] = *first_;
  if (share <= first_share || !is_due(seconds)) return;
  const double left = (seconds - first_seconds) * (1 - share) / (share - first_share);
  print(fmt::format("  {}: {:.0f} %, about {:.0f} s left", name_, 100 * share, left), seconds);
}

void StageProgress::show_waiting(double seconds) {
  if (seconds >= seconds_to_first_line && is_due(seconds))
    print(fmt::format("  {}: {:.0f} s so far", name_, seconds), seconds);
}

void StageProgress::finish() {
  if (drawn_) out_ << "\r\x1b[K" << std::flush;
  drawn_ = false;
}

ShownStage::ShownStage(const StageDisplay& display, std::string name)
    : progress_(display.style, std::move(name), display.out), interrupted_(display.interrupted) {
  if (display.style == ProgressStyle::none) return;
  hold_while_copied();
  std::unique_lock<std::mutex> begins(showing);
  waiting_ = std::thread([this] {
    std::unique_lock<std::mutex> lock(showing);
    waits_ = true;
    ending_.notify_all();
    const std::chrono::duration<double> interval(seconds_between_drawings);
    while (!ending_.wait_for(lock, interval, [this] { return ended_; }))
      if (!says_share_) progress_.show_waiting(std::chrono::duration<double>(Clock::now() - begun_).count());
  });
  ending_.wait(begins, [this] { return waits_; });
}

ShownStage::~ShownStage() {
  {
    const std::lock_guard<std::mutex> lock(showing);
    ended_ = true;
  }
  ending_.notify_all();
  if (waiting_.joinable()) waiting_.join();
  progress_.finish();
}

StageObserver ShownStage::observer() {
  return [this](double share) {
    const double seconds = std::chrono::duration<double>(Clock::now() - begun_).count();
    {
      const std::lock_guard<std::mutex> lock(showing);
      says_share_ = says_share_ || share > 0;
      progress_.show(share, seconds);
    }
    return seconds < seconds_of_grace || !interrupted_ || !interrupted_();
  };
}

}  // namespace etendue
