// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/run/methods/photon_memory.h"

#include "app/render/photon_pictures.h"
#include "app/setup/run_context.h"
#include "app/time/photon_times.h"
#include "solver/photons/solve/solve_photons.h"

namespace etendue {

RunMemory photon_run_memory(const Case& input, const Problem& problem) {
  const int threads = thread_count(input);
  const std::size_t walking =
      estimate_photon_memory(problem, threads) + photon_times_memory(input, problem, threads);
  const HitMemory map = estimate_photon_map_memory(input, problem, threads);
  return {walking + map.most, walking + map.expected};
}

}  // namespace etendue
