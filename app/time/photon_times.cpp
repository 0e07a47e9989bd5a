// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/time/photon_times.h"

#include <utility>

#include "app/time/time_numbers.h"
#include "app/time/time_setup.h"
#include "base/wall_clock.h"
#include "solver/photons/solve/photons_in_time.h"

namespace etendue {
namespace {

/// For a pulse windows about the times, for a step all that came until then.
std::vector<TimeWindow> windows_of(const TimeCase& time) {
  std::vector<TimeWindow> windows;
  for (const double t : time.times) {
    const TimeInterval window = window_about(t, time);
    if (time.in_time.kind == InTime::Kind::step)
      windows.push_back({0, t, 1});
    else
      windows.push_back({window.begin, window.end, window.end - window.begin});
  }
  return windows;
}

/// All numbers of one window, in the order of the quantities.
std::vector<Estimate> in_order(const TimedNumbers& numbers) {
  std::vector<Estimate> all;
  const auto add = [&](const std::vector<Estimate>& of_bands) {
    all.insert(all.end(), of_bands.begin(), of_bands.end());
  };
  for (const auto& point : numbers.fluence) add(point);
  for (const auto& wall : numbers.incoming) add(wall);
  for (std::size_t r = 0; r < numbers.absorbed.size(); ++r) {
    add(numbers.absorbed[r]);
    add(numbers.fluence_mean[r]);
  }
  return all;
}

}  // namespace

std::size_t photon_times_memory(const Case& input, const Problem& problem, int threads) {
  if (!input.time) return 0;
  std::size_t points = input.sensors.size();
  for (const Probe& probe : input.probes) points += probe.points.size();
  return estimate_timed_photon_memory(problem, points, input.time->times.size(), threads);
}

TimeResult photon_times(const Case& input, const Problem& problem, const CellLocator& locator, int threads,
                        const StageDisplay& stages) {
  const WallClock::time_point start = WallClock::now();
  const TimeNumbers numbers(input, problem, locator);
  TimedPlaces places;
  for (const Vec3& point : numbers.fluence_points()) places.fluence.push_back(locator.find(point));
  places.slowness = slowness_of(input, problem);
  ShownStage stage(stages, "photons in time");
  const std::vector<TimedNumbers> found = photons_in_time(
      problem, locator, places, windows_of(*input.time),
      {input.photons->photons, static_cast<std::uint64_t>(input.photons->seed), threads}, stage.observer());
  TimeResult result;
  result.interrupted = found.empty();
  for (const TimeQuantity& quantity : numbers.quantities())
    if (quantity.quantity != "irradiance") result.quantities.push_back(quantity);
  if (!found.empty()) result.histories.resize(result.quantities.size());
  for (const TimedNumbers& window : found) {
    const std::vector<Estimate> values = in_order(window);
    for (std::size_t q = 0; q < values.size(); ++q)
      result.histories[q].push_back({values[q].value, values[q].error});
  }
  result.seconds = seconds_since(start);
  return result;
}

}  // namespace etendue
