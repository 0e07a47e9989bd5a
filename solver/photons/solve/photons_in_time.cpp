// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/photons/solve/photons_in_time.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel/thread_count.h"
#include "solver/photons/solve/batch_statistics.h"
#include "solver/photons/solve/photon_batch.h"

namespace etendue {
namespace {

/// Batches, of which the errors are made.
constexpr double batches_in_time = 64;

/// Where bins begin and end: where windows do.
std::vector<double> edges_of(const std::vector<TimeWindow>& windows) {
  std::vector<double> edges;
  for (const TimeWindow& window : windows) edges.insert(edges.end(), {window.begin, window.end});
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

/// Sums of histories of one band, and what they are sums of.
class TimedSums {
 public:
  /// The problem and the places must outlive it.
  TimedSums(const Problem& problem, const TimedPlaces& places, const std::vector<TimeWindow>& windows)
      : problem_(problem), places_(places), edges_(edges_of(windows)) {
    const TetrahedralMesh& mesh = problem.mesh();
    place_of_cell_.assign(static_cast<std::size_t>(mesh.cell_count()), -1);
    std::int32_t cells = 0;
    for (const std::vector<CellPoint>& points : places.fluence)
      for (const CellPoint& point : points)
        if (std::int32_t& place = place_of_cell_[point.cell.at()]; place < 0) place = cells++;
    for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
      wall_of_face_.push_back(mesh.wall(FaceIndex(f)));
    of_cells_.resize(static_cast<std::size_t>(cells) * bins() * 4);
    of_regions_.resize(mesh.region_names().size() * bins() * 2);
    of_walls_.resize(mesh.wall_names().size() * bins());
    clocks_.resize(starts_at_a_time);
    region_volumes_.assign(mesh.region_names().size(), 0);
    for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
      region_volumes_[static_cast<std::size_t>(mesh.region(CellIndex(c)))] += mesh.volume(CellIndex(c));
  }

  void clear() {
    for (auto* sums : {&of_cells_, &of_regions_, &of_walls_}) std::ranges::fill(*sums, 0.0);
  }

  TimedTally view() {
    return {edges_.data(),           static_cast<std::int32_t>(bins()),
            places_.slowness.data(), place_of_cell_.data(),
            wall_of_face_.data(),    clocks_.data(),
            of_cells_.data(),        of_regions_.data(),
            of_walls_.data()};
  }

  /// Numbers of a window, of each history `scale`: of points, walls, and regions what is absorbed and the
  /// mean.
  std::vector<double> numbers(const TimeWindow& window, double scale) const {
    std::vector<double> values;
    const double by = scale / window.divisor;
    for (const std::vector<CellPoint>& points : places_.fluence)
      values.push_back(by * fluence(points, window));
    for (std::size_t w = 0; w < problem_.mesh().wall_names().size(); ++w)
      values.push_back(by * sum(of_walls_.data() + w * bins(), 1, window));
    for (std::size_t r = 0; r < region_volumes_.size(); ++r) {
      const double* own = of_regions_.data() + r * bins() * 2;
      values.push_back(by * sum(own + 1, 2, window));
      values.push_back(region_volumes_[r] > 0 ? by * sum(own, 2, window) / region_volumes_[r] : 0);
    }
    return values;
  }

 private:
  std::size_t bins() const { return edges_.empty() ? 0 : edges_.size() - 1; }

  /// Of numbers a step apart, those of the bins within a window.
  double sum(const double* first, std::size_t step, const TimeWindow& window) const {
    double sum = 0;
    for (std::size_t k = 0; k < bins(); ++k)
      if (edges_[k] >= window.begin && edges_[k + 1] <= window.end) sum += first[k * step];
    return sum;
  }

  /// Fluence of the linear field in the cells of a point, of whose mass matrix V/20 (1 + delta_ij) the
  /// inverse is 20/V (delta_ij - 1/5).
  double fluence(const std::vector<CellPoint>& points, const TimeWindow& window) const {
    double total = 0, volume = 0;
    for (const CellPoint& point : points) {
      const auto place = static_cast<std::size_t>(place_of_cell_[point.cell.at()]);
      const double* moments = of_cells_.data() + place * bins() * 4;
      for (std::size_t i = 0; i < 4; ++i)
        total += 20 * (point.barycentric[i] - 0.2) * sum(moments + i, 4, window);
      volume += problem_.mesh().volume(point.cell);
    }
    return volume > 0 ? total / volume : 0;
  }

  const Problem& problem_;
  const TimedPlaces& places_;
  std::vector<double> edges_;
  std::vector<std::int32_t> place_of_cell_, wall_of_face_;
  std::vector<double> of_cells_, of_regions_, of_walls_;
  std::vector<PhotonClock> clocks_;
  std::vector<double> region_volumes_;
};

}  // namespace

std::size_t estimate_timed_photon_memory(const Problem& problem, std::size_t points, std::size_t windows,
                                         int threads) {
  const std::size_t bins = 2 * windows, cells = 4 * points;  // a point may lie in some cells
  const std::size_t sums =
      (4 * cells + 2 * problem.media().size() + problem.walls().size()) * bins * sizeof(double) +
      (static_cast<std::size_t>(problem.mesh().cell_count()) +
       static_cast<std::size_t>(problem.mesh().boundary_face_count())) *
          sizeof(std::int32_t);
  return static_cast<std::size_t>(threads) * sums;
}

std::vector<TimedNumbers> photons_in_time(const Problem& problem, const CellLocator& locator,
                                          const TimedPlaces& places, const std::vector<TimeWindow>& windows,
                                          const TimedPhotonOptions& options, const StageObserver& observer) {
  refuse_for_photons(problem);
  if (windows.empty()) return {};
  const PhotonBatches batches(problem, locator, options.seed);
  const auto bands = static_cast<std::size_t>(problem.band_count());
  const double wanted = std::max(1.0, std::floor(options.photons)),
               size = std::ceil(wanted / batches_in_time);
  const int count = static_cast<int>(std::ceil(wanted / size));
  StageCounter counter(static_cast<std::size_t>(wanted) * bands, observer);
  BatchStatistics statistics;  // [band][window][number]
  const int threads = thread_count(options.threads);
#pragma omp parallel num_threads(threads)
  {
    TimedSums sums(problem, places, windows);
#pragma omp for ordered schedule(static, 1)
    for (int i = 0; i < count; ++i) {
      const double before = i * size;
      const auto number = static_cast<std::size_t>(std::min(size, wanted - before));
      std::vector<std::vector<double>> of_bands;
      for (int band = 0; band < problem.band_count() && !counter.stopped(); ++band) {
        sums.clear();
        batches.walk_in_time(band, static_cast<std::uint64_t>(before), number, sums.view(), counter);
        std::vector<double>& own = of_bands.emplace_back();
        for (const TimeWindow& window : windows) {
          const std::vector<double> found =
              sums.numbers(window, batches.power(band) / static_cast<double>(number));
          own.insert(own.end(), found.begin(), found.end());
        }
      }
#pragma omp ordered
      if (!counter.stopped()) {
        std::vector<double> all;
        for (const std::vector<double>& own : of_bands) all.insert(all.end(), own.begin(), own.end());
        statistics.add(all, static_cast<double>(number));
      }
    }
  }
  std::vector<TimedNumbers> results;
  if (counter.stopped()) return results;
  const std::size_t of_band = statistics.size() / bands, of_window = of_band / windows.size();
  for (std::size_t k = 0; k < windows.size(); ++k) {
    std::size_t number = 0;
    const auto next = [&] {
      std::vector<Estimate> estimates;
      for (std::size_t b = 0; b < bands; ++b) {
        const std::size_t at = b * of_band + k * of_window + number;
        estimates.push_back({statistics.mean(at), statistics.error(at)});
      }
      ++number;
      return estimates;
    };
    TimedNumbers& found = results.emplace_back();
    for (std::size_t i = 0; i < places.fluence.size(); ++i) found.fluence.push_back(next());
    for (std::size_t w = 0; w < problem.walls().size(); ++w) found.incoming.push_back(next());
    for (std::size_t r = 0; r < problem.media().size(); ++r) {
      found.absorbed.push_back(next());
      found.fluence_mean.push_back(next());
    }
  }
  return results;
}

}  // namespace etendue
