// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/photons/solve/probe_histories.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "base/parallel/parallel_for.h"
#include "base/parallel/thread_count.h"
#include "base/random/random_stream.h"
#include "solver/photons/kernel/photon_kernel.h"
#include "solver/photons/kernel/photon_turns.h"
#include "solver/photons/solve/batch_statistics.h"
#include "solver/photons/solve/photon_batch.h"
#include "solver/photons/solve/photon_mesh.h"

namespace etendue {
namespace {

constexpr int batches = 32;

/// Directions that fill the sphere evenly, shifted by two random numbers: a lattice of two irrational steps
/// (Roberts 2018, after Cranley and Patterson 1976).
Vec3 direction_of(std::size_t i, const std::array<double, 2>& shift, bool in_plane) {
  constexpr double first = 0.7548776662466927, second = 0.5698402909980532;
  const double n = static_cast<double>(i);
  const double u = shift[0] + n * first, v = shift[1] + n * second;
  const double azimuth = 2 * 3.14159265358979323846 * (v - std::floor(v));
  if (in_plane) return {std::cos(azimuth), std::sin(azimuth), 0};
  const double mu = 2 * (u - std::floor(u)) - 1, sine = std::sqrt(std::max(0.0, 1 - mu * mu));
  return {sine * std::cos(azimuth), sine * std::sin(azimuth), mu};
}

std::size_t batch_size(const ProbeOptions& options) {
  return static_cast<std::size_t>(std::max(1.0, options.histories / batches));
}

/// The walk back from one probe in one band.
class Walk {
 public:
  Walk(const PhotonMesh& mesh, const PhotonProbe& probe, const CellLocator& locator, double range)
      : mesh_(mesh), probe_(probe), cells_(locator.find(probe.point)), range_(range) {}

  /// None where the counter was stopped.
  std::optional<ProbeEstimate> estimate(const PhotonKernels& kernels, const ProbeOptions& options,
                                        std::uint64_t number, StageCounter& counter) const {
    const std::size_t size = batch_size(options);
    BatchStatistics statistics;
    for (int batch = 0; batch < batches && !counter.stopped(); ++batch) {
      const std::uint64_t first = (number * batches + static_cast<std::uint64_t>(batch)) * size;
      statistics.add(
          walk_batch(kernels, {{}, first, options.seed, roulette, watch_by(counter)}, size, counter),
          static_cast<double>(size));
    }
    if (counter.stopped()) return std::nullopt;
    const auto value = [&](std::size_t i) { return Estimate{statistics.mean(i), statistics.error(i)}; };
    ProbeEstimate estimate{value(0), {value(1), value(2), value(3)}, {}};
    if (probe_.normal) estimate.irradiance = value(4);
    return estimate;
  }

 private:
  /// The means of what `size` histories from `range.first` on bring; it has no starts yet.
  std::vector<double> walk_batch(const PhotonKernels& kernels, HistoryRange range, std::size_t size,
                                 const StageCounter& counter) const {
    RandomStream random(range.seed, range.first, RandomUse::lattice);
    std::uint32_t word[4];
    random.next(word);
    const std::array shift = {uniform(word[0]), uniform(word[1])};
    const std::uint64_t first = range.first;
    std::vector<double> sums(5, 0);
    for (std::size_t done = 0; done < size && !counter.stopped(); done += starts_at_a_time) {
      std::vector<PhotonStart> starts;
      for (std::size_t i = done; i < std::min(size, done + starts_at_a_time); ++i)
        starts.push_back(start_towards(direction_of(i, shift, mesh_.view().in_plane)));
      range.starts = starts;
      range.first = first + done;
      std::vector<double> score(starts.size());
      kernels.collect(mesh_.view(), range, score.data());
      for (std::size_t i = 0; i < starts.size(); ++i)
        add(range_ * score[i] / static_cast<double>(size), starts[i], sums);
    }
    return sums;
  }

  void add(double part, const PhotonStart& start, std::vector<double>& sums) const {
    const Vec3 light = -Vec3(start.direction[0], start.direction[1], start.direction[2]);
    sums[0] += part;
    for (int axis = 0; axis < 3; ++axis) sums[1 + static_cast<std::size_t>(axis)] += part * light[axis];
    if (probe_.normal) sums[4] += part * std::max(0.0, -probe_.normal->dot(light));
  }

  /// In the cell, of those that hold the point, through which the path is longest.
  PhotonStart start_towards(const Vec3& direction) const {
    PhotonStart start{{}, {}, 1, 0, -1};
    std::copy(probe_.point.begin(), probe_.point.end(), start.position);
    std::copy(direction.begin(), direction.end(), start.direction);
    double longest = -HUGE_VAL;
    for (const CellPoint& place : cells_)
      if (const double path_length = mesh_.distance_through(place.cell, probe_.point, direction);
          path_length > longest) {
        longest = path_length;
        start.cell = place.cell.value();
      }
    return start;
  }

  const PhotonMesh& mesh_;
  const PhotonProbe& probe_;
  std::vector<CellPoint> cells_;
  double range_;  ///< [sr] of all directions
};

}  // namespace

bool can_walk_back(const Problem& problem) { return problem.lights().empty() && is_reciprocal(problem); }

std::vector<std::vector<ProbeEstimate>> walk_back_from(const std::vector<PhotonProbe>& probes,
                                                       const Problem& problem, const CellLocator& locator,
                                                       const ProbeOptions& options,
                                                       const StageObserver& observer) {
  const PhotonKernels kernels = choose_photon_kernels();
  const DirectionalInput input(problem);
  std::vector<std::vector<ProbeEstimate>> found(probes.size());
  const int threads = thread_count(options.threads);
  const auto bands = static_cast<std::size_t>(problem.band_count());
  StageCounter counter(probes.size() * bands * batches * batch_size(options), observer);
  for (int band = 0; band < problem.band_count() && !counter.stopped(); ++band) {
    const PhotonMesh mesh(problem, input, band);
    parallel_for(probes.size(), threads, 1, [&](std::size_t i) {
      const Walk walk(mesh, probes[i], locator, full_range(problem.space()));
      if (const auto estimate = walk.estimate(kernels, options, i, counter)) found[i].push_back(*estimate);
      return !counter.stopped();
    });
  }
  for (auto& of_bands : found)
    if (of_bands.size() < bands) of_bands.clear();
  return found;
}

}  // namespace etendue
