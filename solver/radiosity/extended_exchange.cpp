// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/extended_exchange.h"

#include <algorithm>
#include <cmath>

#include "solver/problem/mirror.h"
#include "solver/radiosity/even_points.h"

namespace etendue {
namespace {

// Passes after which closing gives up.
constexpr int most_closing_passes = 100;
// Rows that are traced before they are put together.
constexpr std::size_t rows_at_once = 256;

bool is_even(const Wall& wall) {
  const auto same = [](const auto& values) {
    return std::ranges::all_of(values, [&](const auto& value) { return value == values.front(); });
  };
  return same(wall.specular) && same(wall.glossy);
}

/// Whether what walls redirect is the same in all bands.
bool bands_are_alike(const Problem& problem) { return std::ranges::all_of(problem.walls(), is_even); }

}  // namespace

/// What the rays of one patch bring together.
struct ExtendedExchange::RayRow {
  std::size_t stored;
  std::vector<double> values;      ///< [patch][stored]
  std::vector<char> is_met;        ///< [patch]
  std::vector<std::uint32_t> met;  ///< patches with values

  RayRow(std::size_t patches, std::size_t numbers)
      : stored(numbers), values(patches * numbers, 0), is_met(patches, 0) {}

  void add(std::size_t patch, const std::vector<double>& weight, double factor) {
    if (is_met[patch] == 0) met.push_back(static_cast<std::uint32_t>(patch));
    is_met[patch] = 1;
    for (std::size_t b = 0; b < stored; ++b) values[patch * stored + b] += factor * weight[b];
  }

  /// Hands out the entries in order, and forgets them.
  std::pair<std::vector<std::uint32_t>, std::vector<float>> take() {
    std::ranges::sort(met);
    std::vector<float> taken;
    for (const std::uint32_t patch : met) {
      is_met[patch] = 0;
      for (double* value = values.data() + patch * stored; value < values.data() + (patch + 1) * stored;
           ++value)
        taken.push_back(static_cast<float>(std::exchange(*value, 0.0)));
    }
    return {std::exchange(met, {}), std::move(taken)};
  }
};

struct ExtendedExchange::TracedRow {
  std::pair<std::vector<std::uint32_t>, std::vector<float>> found, change;
};

ExtendedExchange::ExtendedExchange(const Exchange& straight, const Problem& problem,
                                   const WallPatches& patches, Redirection by, int rays)
    : straight_(straight),
      paths_(problem, patches, by, straight.threads()),
      rays_(rays),
      stored_(bands_are_alike(problem) ? 1 : paths_.bands()),
      found_(stored_),
      change_(stored_),
      scale_(straight.size() * paths_.bands(), 1) {
  for (const int wall : patches.walls)
    for (std::size_t b = 0; b < bands(); ++b)
      redirects_.push_back(redirected_part_of_isotropic(problem.wall(wall), b, by));
  trace(problem, patches);
}

void ExtendedExchange::trace(const Problem& problem, const WallPatches& patches) {
  SparseRows one_way(stored_);
  std::vector<TracedRow> rows;
  for (std::size_t begin = 0; begin < size(); begin += rows_at_once) {
    rows.assign(std::min(rows_at_once, size() - begin), {});
#pragma omp parallel num_threads(straight_.threads())
    {
      RayRow found(size(), stored_), change(size(), stored_);
#pragma omp for schedule(dynamic, 4)
      for (std::size_t i = 0; i < rows.size(); ++i)
        rows[i] = traced_row(begin + i, problem, patches, found, change);
    }
    for (const TracedRow& row : rows) {
      one_way.add_row(row.found.first, row.found.second);
      change_.add_row(row.change.first, row.change.second);
    }
  }
  found_ = one_way.symmetric_part();
}

// Each ray stands for the part A/N of the patch: what it meets straight is in G_0 already. The angle at which
// it leaves is that at which light arrives along it.
ExtendedExchange::TracedRow ExtendedExchange::traced_row(std::size_t patch, const Problem& problem,
                                                         const WallPatches& patches, RayRow& found,
                                                         RayRow& change) const {
  const FlatPatch& from = patches.patches[patch];
  const Wall& wall = problem.wall(patches.walls[patch]);
  const bool changes =
      wall.refractive_index != 1 || (paths_.by() == Redirection::mirrors_and_lobes && wall.is_glossy());
  EvenPoints<7> points(patch, RandomUse::path);
  std::vector<double> weight, deviation(stored_), changed(stored_);
  const double part = from.area() / rays_;
  for (int i = 0; i < rays_; ++i) {
    const std::array<double, 7>& at = points.next();
    const double cosine = std::sqrt(1 - at[2]);
    for (std::size_t b = 0; b < stored_ && changes; ++b)
      deviation[b] = redirected_part(wall, b, cosine, paths_.by()) - redirects_[patch * bands() + b];
    const PathNumbers numbers(patch * static_cast<std::uint64_t>(rays_) + static_cast<std::uint64_t>(i),
                              {at[4], at[5], at[6]});
    paths_.follow(from.point_at(at[0], at[1]), direction_about(from.normal(), cosine, at[3]), numbers, weight,
                  [&](const ExtendedPaths::Meeting& meeting) {
                    if (!meeting.first) found.add(meeting.patch, meeting.weight, part);
                    if (!changes) return;
                    for (std::size_t b = 0; b < stored_; ++b) changed[b] = deviation[b] * meeting.weight[b];
                    change.add(meeting.patch, changed, part);
                  });
  }
  return {found.take(), change.take()};
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
  change_.add_product(scaled, bands(), result, straight_.threads());
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = scale_[i] * result[i] + redirects_[i] * arriving[i];
  return result;
}

// Of light that patch k sends, d_k sum over j of ((1 - a_j) G_jk - C_jk) d_j stays; see Exchange::close().
ExtendedClosing ExtendedExchange::close(double tolerance) {
  std::fill(scale_.begin(), scale_.end(), 1.0);
  ExtendedClosing closing;
  std::vector<double> stays(redirects_.size());
  for (std::size_t i = 0; i < stays.size(); ++i) stays[i] = 1 - redirects_[i];
  while (closing.passes < most_closing_passes) {
    ++closing.passes;
    std::vector<double> kept = times(stays), lost(kept.size(), 0);
    change_.add_transposed_product(scale_, bands(), lost);
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

std::size_t ExtendedExchange::bytes_of(std::size_t patches, int rays, std::size_t bands) {
  // Few paths turn more than twice; both ways, and once more while they are put together.
  const std::size_t entries = patches * std::min(patches, 4 * static_cast<std::size_t>(rays));
  return 2 * entries * SparseRows::bytes_of(bands);
}

}  // namespace etendue
