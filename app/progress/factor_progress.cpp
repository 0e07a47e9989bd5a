// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/progress/factor_progress.h"

#include <fmt/format.h>

#include "app/progress/display_times.h"

namespace etendue {

void FactorDisplay::show(const RadiosityStage& stage, double seconds) {
  if (stage.done == 0) {
    finish();
    begun_at_ = shown_at_ = seconds;
    return;
  }
  if (style_ == ProgressStyle::none) return;
  const bool draws = style_ == ProgressStyle::bar;
  if (seconds < shown_at_ + (draws ? seconds_between_drawings : seconds_between_lines)) return;
  shown_at_ = seconds;
  const std::string text = fmt::format("  {}: {:.0f} %, about {:.0f} s left", what_, 100 * stage.done,
                                       (seconds - begun_at_) * (1 - stage.done) / stage.done);
  if (draws)
    out_ << "\r" << text << "\x1b[K" << std::flush;
  else
    out_ << text << std::endl;
  drawn_ = draws;
}

void FactorDisplay::finish() {
  if (drawn_) out_ << "\r\x1b[K" << std::flush;
  drawn_ = false;
}

}  // namespace etendue
