// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/extended/extended_exchange.h"

#include <algorithm>
#include <cmath>

#include "solver/radiosity/extended/extended_trace.h"

namespace etendue {
namespace {

bool is_even(const Wall& wall) {
  const auto same = [](const auto& values) {
    return std::ranges::all_of(values, [&](const auto& value) { return value == values.front(); });
  };
  return same(wall.specular) && same(wall.glossy);
}

/// Returns whether what walls redirect is the same in all bands.
bool bands_are_alike(const Problem& problem) { return std::ranges::all_of(problem.walls(), is_even); }

}  // namespace

ExtendedExchange::ExtendedExchange(const Exchange& straight, const Problem& problem,
                                   const WallPatches& patches, Redirection by, int rays)
    : straight_(straight),
      paths_(problem, patches, by, straight.threads()),
      stored_(bands_are_alike(problem) ? 1 : paths_.bands()),
      found_(stored_),
      change_(stored_),
      straight_share_(stored_),
      straight_change_(stored_),
      scale_(straight.size() * paths_.bands(), 1) {
  for (const int wall : patches.walls)
    for (std::size_t b = 0; b < bands(); ++b)
      redirects_.push_back(redirected_part_of_isotropic(problem.wall(wall), b, by));
  const TracedRays traced = trace_rays(problem, patches, paths_, rays, stored_, straight.threads());
  found_ = SparseRows::half_sum(traced.extended.light, traced.extended.light);
  change_ = SparseRows::half_sum(traced.extended.more_where_left, traced.extended.more_where_met);
  straight_share_ = SparseRows::half_sum(traced.straight.more_where_left, traced.straight.more_where_met);
  const SparseRows light = SparseRows::half_sum(traced.straight.light, traced.straight.light);
  std::vector<double> sums(size() * stored_, 0);
  for (std::size_t j = 0; j < size(); ++j) {
    if (straight_share_.entries_of(j) == 0) continue;
    light.add_row_to(j, stored_, sums);
    straight_share_.change_row(
        j, [&](std::size_t k, std::size_t b, double more) { return more / sums[k * stored_ + b]; });
    std::fill(sums.begin(), sums.end(), 0.0);
  }
}

// Of straight paths the rays say at which angles they meet, and G_0 how much is exchanged. Their mean lies
// between the most and the least that a wall redirects, so no more is redirected than arrives.
void ExtendedExchange::weigh_straight_change() {
  straight_change_ = straight_share_;
  for (std::size_t j = 0; j < size(); ++j) {
    if (straight_change_.entries_of(j) == 0) continue;
    const std::vector<double> exchanged = straight_.row(j);
    straight_change_.change_row(
        j, [&](std::size_t k, std::size_t, double share) { return share * exchanged[k]; });
  }
}

std::vector<double> ExtendedExchange::times(std::span<const double> x) const {
  std::vector<double> scaled(x.begin(), x.end());
  for (std::size_t i = 0; i < scaled.size(); ++i) scaled[i] *= scale_[i];
  std::vector<double> result = straight_.times(scaled, bands());
  found_.add_product(scaled, bands(), result, straight_.threads());
  for (std::size_t i = 0; i < result.size(); ++i) result[i] *= scale_[i];
  return result;
}

std::vector<double> ExtendedExchange::row(std::size_t j) const {
  const std::vector<double> straight = straight_.row(j);
  std::vector<double> result(size() * bands());
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = straight[i / bands()];
  found_.add_row_to(j, bands(), result);
  for (std::size_t i = 0; i < result.size(); ++i) result[i] *= scale_[j * bands() + i % bands()] * scale_[i];
  return result;
}

std::vector<double> ExtendedExchange::redirected(std::span<const double> x,
                                                 std::span<const double> arriving) const {
  std::vector<double> scaled(x.begin(), x.end()), result(x.size(), 0);
  for (std::size_t i = 0; i < scaled.size(); ++i) scaled[i] *= scale_[i];
  for (const SparseRows* change : {&change_, &straight_change_})
    change->add_product(scaled, bands(), result, straight_.threads());
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = scale_[i] * result[i] + redirects_[i] * arriving[i];
  return result;
}

// Of light that patch k sends, d_k sum over j of ((1 - a_j) G_jk - C_jk) d_j stays; see Exchange::close().
ExtendedClosing ExtendedExchange::close(double tolerance) {
  std::fill(scale_.begin(), scale_.end(), 1.0);
  weigh_straight_change();
  ExtendedClosing closing;
  std::vector<double> stays(redirects_.size());
  for (std::size_t i = 0; i < stays.size(); ++i) stays[i] = 1 - redirects_[i];
  while (closing.passes < most_closing_passes) {
    ++closing.passes;
    std::vector<double> kept = times(stays), lost(kept.size(), 0);
    for (const SparseRows* change : {&change_, &straight_change_})
      change->add_transposed_product(scale_, bands(), lost);
    double largest = 0, squares = 0;
    for (std::size_t i = 0; i < kept.size(); ++i) {
      const double sum = kept[i] - scale_[i] * lost[i];
      const double ratio = sum / straight_.patches()[i / bands()].area();
      largest = std::max(largest, std::abs(ratio - 1));
      squares += (ratio - 1) * (ratio - 1);
      if (ratio > 0) scale_[i] /= std::sqrt(ratio);
    }
    closing.closed_row_sum = largest;
    if (closing.passes == 1) {
      closing.row_sum = largest;
      closing.row_sum_mean = std::sqrt(squares / static_cast<double>(kept.size()));
    }
    if (largest <= tolerance) break;
  }
  return closing;
}

}  // namespace etendue
