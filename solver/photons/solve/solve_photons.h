// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "base/parallel/rank_group.h"
#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/photons/solve/batch_statistics.h"
#include "solver/problem/problem.h"
#include "solver/solution/solution.h"
#include "solver/solution/solve_observer.h"

namespace etendue {

/// The sums of a run by photons, to which more histories can be added. Values are for all bands together.
struct PhotonSums {
  BatchStatistics fluence;      ///< [cell][4][band]
  BatchStatistics cell_means;   ///< [cell][band] of the fluence
  BatchStatistics net_flux;     ///< [cell][4][3][band]
  BatchStatistics irradiance;   ///< [boundary face][3][band]
  BatchStatistics face_means;   ///< [boundary face][band] of the irradiance
  BatchStatistics derived;      ///< what the observer of batches made of them
  BatchStatistics absorbed;     ///< [cell][band] where a medium depends on the direction; else empty
  BatchStatistics exitance;     ///< [boundary face][3][band] where walls reflect by the angle; else empty
  std::uint64_t histories = 0;  ///< per band; also the number of the next

  std::vector<double> packed() const;
  /// Throws InputError where the numbers are not those of such sums. What comes after them does not count.
  static PhotonSums unpacked(std::span<const double> numbers);
};

struct PhotonOptions {
  double photons = 1e6;  ///< histories per band; with an error to reach, at most
  double until = 0;      ///< relative standard error of the fluence to reach; 0: all histories are walked
  std::uint64_t seed = 1;
  int threads = 0;                      ///< 0: all cores
  RankGroup* ranks = nullptr;           ///< processes that share the histories; null: this one alone
  const PhotonSums* initial = nullptr;  ///< more histories are added to these; must outlive the call
};

struct PhotonProgress {
  double histories = 0;  ///< per band, those of earlier runs and of batches that are not whole too
  double planned = 0;
  int batches = 0;                ///< that are whole; a solution needs one
  std::span<const double> error;  ///< [band] relative, of the fluence; infinite or empty: not known yet
  double until = 0;
  double seconds = 0;
  double seconds_left = 0;  ///< negative: unknown
};
/// Called after each batch and some times a second within batches, by one thread at a time. May ask to stop:
/// that is done at once, and batches that are not whole then are left out.
using PhotonObserver = std::function<SolveControl(const PhotonProgress&)>;

/// Numbers made of the fields that one batch estimates; they must be linear in them. Called for one batch at
/// a time.
using BatchReader = std::function<std::vector<double>(const Solution& batch)>;

/// What a solution by photons has beside the fields.
struct PhotonReport {
  std::vector<double> error;       ///< [band] relative error of the fluence, volume-weighted root mean square
  std::vector<double> cell_error;  ///< [band] median over the cells of the relative error of the mean
  std::vector<double> figure;      ///< [band] 1/(error^2 seconds) with the processor's seconds
  double segments = 0, collisions = 0, lost = 0;  ///< of this run, all bands
  double histories = 0;                           ///< of this run, all bands
  double seconds = 0;                             ///< of the processor, in this run's histories
};

struct PhotonSolution {
  Solution solution;
  PhotonSums sums;
  PhotonReport report;
};

/// Bytes that solve_photons() may take at its peak: an upper estimate.
std::size_t estimate_photon_memory(const Problem& problem, int threads);

/// Solves by Monte Carlo: histories of photons through the cells, with the light that they lose to absorption
/// taken out along the path, and track lengths as estimators of the fluence and net flux in each cell.
/// Where it is stopped before the first batch is whole, the solution has no fields.
/// Throws InputError where photons do not know what the problem asks.
PhotonSolution solve_photons(const Problem& problem, const CellLocator& locator, const PhotonOptions& options,
                             const PhotonObserver& observer = {}, const BatchReader& reader = {});

}  // namespace etendue
