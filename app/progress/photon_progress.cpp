// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/progress/photon_progress.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/progress/display_times.h"

namespace etendue {
namespace {

std::string photon_state(const PhotonProgress& progress) {
  const double error = progress.error.empty() ? 0 : *std::ranges::max_element(progress.error);
  std::string text = fmt::format("photons {:9.3g} of {:.3g}", progress.histories, progress.planned);
  if (progress.batches > 1) text += fmt::format("  error {:.2f} %", 100 * error);
  if (progress.until > 0) text += fmt::format("  wanted {:.2g} %", 100 * progress.until);
  text += fmt::format("  {:.1f} s", progress.seconds);
  if (progress.seconds_left >= 0) text += fmt::format(", about {:.0f} s left", progress.seconds_left);
  return text;
}

}  // namespace

void PhotonDisplay::show(const PhotonProgress& progress) {
  if (style_ == ProgressStyle::none) return;
  const bool draws = style_ == ProgressStyle::bar;
  waiting_ = photon_state(progress);
  const double interval = draws ? seconds_between_drawings : seconds_between_lines;
  if (progress.seconds < (shown_at_ ? *shown_at_ + interval : draws ? interval : seconds_to_first_line))
    return;
  shown_at_ = progress.seconds;
  if (draws)
    out_ << "\r  " << waiting_ << "\x1b[K" << std::flush;
  else
    out_ << "  " << waiting_ << std::endl;
  drawn_ = draws;
  waiting_.clear();
}

void PhotonDisplay::finish() {
  if (!waiting_.empty()) out_ << (drawn_ ? "\r  " : "  ") << waiting_ << (drawn_ ? "\x1b[K" : "");
  if (drawn_ || !waiting_.empty()) out_ << std::endl;
  waiting_.clear();
  drawn_ = false;
}

}  // namespace etendue
