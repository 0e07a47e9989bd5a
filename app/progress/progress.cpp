// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/progress/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "app/progress/display_times.h"

namespace etendue {
namespace {

constexpr int bar_width = 24;

std::string duration(double seconds) {
  if (seconds < 100) return fmt::format("{:.1f} s", seconds);
  if (seconds < 6000) return fmt::format("{:.1f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

std::string sweep_state(const SweepProgress& progress, double residual) {
  std::string text = fmt::format("sweep {:>4}  residual {:8.2e}  tolerance {:.0e}  {}", progress.sweep,
                                 residual, progress.tolerance, duration(progress.seconds));
  if (progress.seconds_left >= 0) text += ", about " + duration(progress.seconds_left) + " left";
  return text;
}

/// The share of the way from the first residual to the tolerance, on a logarithmic scale.
double share_done(double first, double now, double tolerance) {
  if (now <= tolerance) return 1;
  if (!(first > now) || !(tolerance > 0)) return 0;
  return std::log(first / now) / std::log(first / tolerance);
}

double largest(std::span<const double> residuals) {
  return residuals.empty() ? 0 : *std::max_element(residuals.begin(), residuals.end());
}

}  // namespace

void ProgressDisplay::show(const SweepProgress& progress) {
  const double residual = largest(progress.residual);
  if (first_residual_ <= 0) first_residual_ = residual;
  if (style_ == ProgressStyle::bar) draw_bar(progress, residual);
  if (style_ != ProgressStyle::plain) return;
  waiting_ = sweep_state(progress, residual);
  if (progress.sweep > 1 && progress.seconds < shown_at_ + seconds_between_lines) return;
  shown_at_ = progress.seconds;
  print_line(waiting_);
}

void ProgressDisplay::draw_bar(const SweepProgress& progress, double residual) {
  const double share = share_done(first_residual_, residual, progress.tolerance);
  const int filled = static_cast<int>(std::lround(share * bar_width));
  // Back to the start of the line, and clear the rest of the longer line before.
  out_ << fmt::format("\r  [{:#<{}}{:.<{}}]  {}\x1b[K", "", filled, "", bar_width - filled,
                      sweep_state(progress, residual))
       << std::flush;
  bar_drawn_ = true;
}

void ProgressDisplay::print_line(const std::string& line) {
  out_ << "  " << line << std::endl;
  waiting_.clear();
}

void ProgressDisplay::finish() {
  if (bar_drawn_) out_ << std::endl;
  bar_drawn_ = false;
  if (!waiting_.empty()) print_line(waiting_);
}

ProgressStyle resolved_style(ProgressStyle asked, const std::ostream& out) {
  if (asked != ProgressStyle::automatic) return asked;
  const bool terminal = &out == &std::cout && isatty(STDOUT_FILENO) != 0;
  return terminal ? ProgressStyle::bar : ProgressStyle::plain;
}

}  // namespace etendue
