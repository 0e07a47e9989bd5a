// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/parallel/stage_observer.h"
#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/photons/solve/probe_histories.h"
#include "solver/problem/problem.h"

namespace etendue {

/// Times over which light is added up.
struct TimeWindow {
  double begin = 0, end = 0;  ///< [time]
  double divisor = 1;         ///< of the sum: the width for a mean [time], 1 for the sum [unit of time]
};

/// What is read of light in time.
struct TimedPlaces {
  std::vector<std::vector<CellPoint>> fluence;  ///< points, from CellLocator::find
  std::vector<double> slowness;                 ///< [region] [time/length]
};

struct TimedPhotonOptions {
  double photons = 1e6;  ///< histories per band
  std::uint64_t seed = 1;
  int threads = 0;  ///< 0: all cores
};

/// Numbers in one window, [band] each.
struct TimedNumbers {
  std::vector<std::vector<Estimate>> fluence;       ///< [point] [power/length^2]
  std::vector<std::vector<Estimate>> incoming;      ///< [wall] [power]
  std::vector<std::vector<Estimate>> absorbed;      ///< [region] [power]
  std::vector<std::vector<Estimate>> fluence_mean;  ///< [region] [power/length^2]
};

/// Bytes that photons_in_time() takes beside the meshes of solve_photons().
std::size_t estimate_timed_photon_memory(const Problem& problem, std::size_t points, std::size_t windows,
                                         int threads);

/// Light in time by Monte Carlo: everything that emits sends all its light, as much as in one unit of time,
/// at t = 0, and histories carry the time that they take. Of a source that is switched on at t = 0 the light
/// at t is the sum from 0 to t. The fluence at a point is that of the linear field in its cell, as in
/// solve_photons(), with which the histories are shared. Returns a result for each window; none where the
/// observer stops it. Throws InputError
/// where photons do not know what the problem asks.
std::vector<TimedNumbers> photons_in_time(const Problem& problem, const CellLocator& locator,
                                          const TimedPlaces& places, const std::vector<TimeWindow>& windows,
                                          const TimedPhotonOptions& options,
                                          const StageObserver& observer = {});

}  // namespace etendue
