// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/extended/extended_trace.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/random/even_points.h"

namespace etendue {
namespace {

// Rows that are traced before they are put together.
constexpr std::size_t rows_at_once = 256;

struct Entries {
  std::vector<std::uint32_t> patches;
  std::vector<float> values;  ///< [entry][stored]
};

/// Adds up what the rays of one patch bring to the others.
class RowSum {
 public:
  RowSum(std::size_t patches, std::size_t stored)
      : stored_(stored), values_(patches * stored, 0), is_met_(patches, 0) {}

  void add(std::size_t patch, double factor, const double* more, const std::vector<double>& weight) {
    if (is_met_[patch] == 0) met_.push_back(static_cast<std::uint32_t>(patch));
    is_met_[patch] = 1;
    for (std::size_t b = 0; b < stored_; ++b)
      values_[patch * stored_ + b] += factor * weight[b] * (more != nullptr ? more[b] : 1);
  }

  /// Hands out the entries in order, and forgets them.
  Entries take() {
    std::ranges::sort(met_);
    Entries taken;
    for (const std::uint32_t patch : met_) {
      is_met_[patch] = 0;
      for (std::size_t i = patch * stored_; i < (patch + 1) * stored_; ++i)
        taken.values.push_back(static_cast<float>(std::exchange(values_[i], 0.0)));
    }
    taken.patches = std::exchange(met_, {});
    return taken;
  }

 private:
  std::size_t stored_;
  std::vector<double> values_;      ///< [patch][stored]
  std::vector<char> is_met_;        ///< [patch]
  std::vector<std::uint32_t> met_;  ///< patches with values
};

/// The six sums of TracedRays, in the order light, more where left, more where met; straight ones first.
constexpr std::size_t sums = 6;

bool redirects_by_angle(const Wall& wall, Redirection by) {
  return wall.refractive_index != 1 || (by == Redirection::mirrors_and_lobes && wall.is_glossy());
}

/// Sends the rays of one patch after the other.
class RayRows {
 public:
  RayRows(const Problem& problem, const WallPatches& patches, const ExtendedPaths& paths, int rays,
          std::size_t stored)
      : problem_(problem), patches_(patches), paths_(paths), rays_(rays), stored_(stored) {
    bool any = false;
    for (const Wall& wall : problem.walls()) {
      by_angle_.push_back(redirects_by_angle(wall, paths.by()) ? 1 : 0);
      any = any || by_angle_.back() != 0;
      for (std::size_t b = 0; b < stored; ++b)
        isotropic_.push_back(redirected_part_of_isotropic(wall, b, paths.by()));
    }
    for (std::size_t i = 0; i < sums; ++i)
      sums_.emplace_back(i == 3 || any ? patches.patches.size() : 0, stored);
  }

  std::array<Entries, sums> row(std::size_t patch) {
    const FlatPatch& from = patches_.patches[patch];
    const std::size_t left = wall_of(patch);
    EvenPoints<7> points(patch, RandomUse::path_start);
    for (int i = 0; i < rays_; ++i) {
      const std::array<double, 7>& at = points.next();
      const double cosine = std::sqrt(1 - at[2]);
      if (by_angle_[left] != 0) find_more(left, cosine, more_left_);
      const PathNumbers numbers(patch * static_cast<std::uint64_t>(rays_) + static_cast<std::uint64_t>(i),
                                {at[4], at[5], at[6]});
      paths_.follow(from.point_at(at[0], at[1]), direction_about(from.normal(), cosine, at[3]), numbers,
                    weight_,
                    [&](const ExtendedPaths::Meeting& meeting) { add(left, from.area() / rays_, meeting); });
    }
    std::array<Entries, sums> entries;
    for (std::size_t i = 0; i < sums; ++i) entries[i] = sums_[i].take();
    return entries;
  }

 private:
  std::size_t wall_of(std::size_t patch) const { return static_cast<std::size_t>(patches_.walls[patch]); }

  /// [stored] by how much more is redirected at this angle than of isotropic light.
  void find_more(std::size_t wall, double cosine, std::vector<double>& more) const {
    more.resize(stored_);
    for (std::size_t b = 0; b < stored_; ++b)
      more[b] = redirected_part(problem_.wall(static_cast<int>(wall)), b, cosine, paths_.by()) -
                isotropic_[wall * stored_ + b];
  }

  void add(std::size_t left, double area, const ExtendedPaths::Meeting& meeting) {
    const std::size_t met = wall_of(meeting.patch), first = meeting.first ? 0 : 3;
    const bool by_angle = by_angle_[left] != 0 || by_angle_[met] != 0;
    if (by_angle || !meeting.first) sums_[first].add(meeting.patch, area, nullptr, meeting.weight);
    if (by_angle_[left] != 0) sums_[first + 1].add(meeting.patch, area, more_left_.data(), meeting.weight);
    if (by_angle_[met] == 0) return;
    find_more(met, meeting.cosine, more_met_);
    sums_[first + 2].add(meeting.patch, area, more_met_.data(), meeting.weight);
  }

  const Problem& problem_;
  const WallPatches& patches_;
  const ExtendedPaths& paths_;
  int rays_;
  std::size_t stored_;
  std::vector<char> by_angle_;     ///< [wall]
  std::vector<double> isotropic_;  ///< [wall][stored]
  std::vector<RowSum> sums_;
  std::vector<double> weight_, more_left_, more_met_;
};

}  // namespace

TracedRays trace_rays(const Problem& problem, const WallPatches& patches, const ExtendedPaths& paths,
                      int rays, std::size_t stored, int threads) {
  TracedRays traced{TracedRays::Sums(stored), TracedRays::Sums(stored)};
  const std::array<SparseRows*, sums> parts = {
      &traced.straight.light, &traced.straight.more_where_left, &traced.straight.more_where_met,
      &traced.extended.light, &traced.extended.more_where_left, &traced.extended.more_where_met};
  const std::size_t count = patches.patches.size();
  std::vector<std::array<Entries, sums>> rows;
  for (std::size_t begin = 0; begin < count; begin += rows_at_once) {
    rows.assign(std::min(rows_at_once, count - begin), {});
#pragma omp parallel num_threads(threads)
    {
      RayRows own(problem, patches, paths, rays, stored);
#pragma omp for schedule(dynamic, 4)
      for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = own.row(begin + i);
    }
    for (const auto& row : rows)
      for (std::size_t i = 0; i < sums; ++i) parts[i]->add_row(row[i].patches, row[i].values);
  }
  return traced;
}

// A ray from anywhere meets a wall that redirects with the share s of these walls in the area, and with no
// more than their mean of what they redirect it goes on: s + s a s + … meetings beyond the first.
std::size_t bytes_of_traced_rays(const Problem& problem, std::size_t patches, int rays) {
  constexpr Redirection by = Redirection::mirrors_and_lobes;
  const TetrahedralMesh& mesh = problem.mesh();
  double area = 0, redirecting = 0, redirected = 0;
  bool by_angle = false;
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const Wall& wall = problem.wall(mesh.wall(FaceIndex(f)));
    area += mesh.area(FaceIndex(f));
    if (!redirects(wall, by)) continue;
    by_angle = by_angle || redirects_by_angle(wall, by);
    redirecting += mesh.area(FaceIndex(f));
    double most = 0;
    for (std::size_t b = 0; b < wall.diffuse.size(); ++b)
      most = std::max(most, redirected_part_of_isotropic(wall, b, by));
    redirected += most * mesh.area(FaceIndex(f));
  }
  if (redirecting == 0) return 0;
  const double share = redirecting / area, mean = redirected / redirecting;
  const double later = rays * share / std::max(1 - share * mean, 1e-2);
  const auto count = static_cast<double>(patches);
  const auto entries = [&](double meetings) { return count * std::min(count, meetings); };
  const auto each = static_cast<double>(SparseRows::bytes_of(static_cast<std::size_t>(problem.band_count())));
  // As traced, turned round, and their half sum, which has up to twice as many; vectors that grow.
  constexpr double copies = 1 + 1 + 2, growth = 1.5;
  const double sums_of_angles = by_angle ? 2 * entries(later) + 3 * entries(rays) : 0;
  return static_cast<std::size_t>(each * growth * copies * (entries(later) + sums_of_angles));
}

}  // namespace etendue
