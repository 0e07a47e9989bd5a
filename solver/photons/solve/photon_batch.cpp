// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/photons/solve/photon_batch.h"

#include <algorithm>
#include <array>

#include "base/parallel/processor_timer.h"

namespace etendue {
namespace {

// Of a photon map: hits of even weight say more than as many of which most weigh little (Jensen 2001).
constexpr double roulette_of_hits = 0.1;

}  // namespace

PhotonBatches::PhotonBatches(const Problem& problem, const CellLocator& locator, std::uint64_t seed)
    : problem_(problem), seed_(seed), kernels_(choose_photon_kernels()), input_(problem) {
  for (int b = 0; b < problem.band_count(); ++b)
    bands_.push_back(std::make_unique<Band>(problem, input_, locator, b));
}

PhotonBatches::Outcome PhotonBatches::walk(std::uint64_t first, std::size_t count,
                                           StageCounter& counter) const {
  Outcome outcome{empty_fields(problem_), {}, 0};
  TallySums sums(problem_.mesh());
  const double start = processor_seconds();
  for (int b = 0; b < problem_.band_count(); ++b) {
    const Band& band = *bands_[static_cast<std::size_t>(b)];
    if (band.sources.power() == 0) {
      counter.add(count);
      continue;
    }
    sums.clear();
    for (std::size_t done = 0; done < count; done += starts_at_a_time) {
      const std::vector<PhotonStart> starts =
          band.sources.starts(seed_, {first, count}, done, std::min(starts_at_a_time, count - done));
      const PhotonCounts counts = kernels_.follow(
          band.mesh.view(), {starts, first + done, seed_, roulette, watch_by(counter)}, sums.view());
      if (counter.stopped()) return {};
      outcome.counts.segments += counts.segments;
      outcome.counts.collisions += counts.collisions;
      outcome.counts.lost += counts.lost;
    }
    sums.to_fields(problem_, b, band.sources.power() / static_cast<double>(count), outcome.fields);
  }
  complete_fields(problem_, outcome.fields);
  input_.emission.add_to(outcome.fields);
  outcome.seconds = processor_seconds() - start;
  return outcome;
}

void PhotonBatches::bring(Outcome& outcome, RankGroup& ranks, int from) const {
  if (ranks.rank() != from) {
    outcome.fields = empty_fields(problem_);
    complete_fields(problem_, outcome.fields);
    input_.emission.add_to(outcome.fields);
  }
  Solution& fields = outcome.fields;
  for (std::vector<double>* values :
       {&fields.fluence, &fields.net_flux, &fields.absorbed, &fields.irradiance, &fields.exitance})
    ranks.bring(*values, from);
  PhotonCounts& counts = outcome.counts;
  std::array numbers = {static_cast<double>(counts.segments), static_cast<double>(counts.collisions),
                        static_cast<double>(counts.lost), outcome.seconds};
  ranks.bring(numbers, from);
  counts.segments = static_cast<std::uint64_t>(numbers[0]);
  counts.collisions = static_cast<std::uint64_t>(numbers[1]);
  counts.lost = static_cast<std::uint64_t>(numbers[2]);
  outcome.seconds = numbers[3];
}

double PhotonBatches::beyond_bounds(RankGroup* ranks) const {
  const auto [beyond, draws] = input_.media.beyond_bounds();
  double all_beyond = 0, all_draws = 0;
  for (int rank = 0; rank < (ranks != nullptr ? ranks->count() : 1); ++rank) {
    std::array numbers = {static_cast<double>(beyond), static_cast<double>(draws)};
    if (ranks != nullptr) ranks->bring(numbers, rank);
    all_beyond += numbers[0];
    all_draws += numbers[1];
  }
  return all_draws > 0 ? all_beyond / all_draws : 0;
}

void PhotonBatches::walk_in_time(int number, std::uint64_t first, std::size_t count, const TimedTally& tally,
                                 StageCounter& counter) const {
  const Band& band = *bands_[static_cast<std::size_t>(number)];
  if (band.sources.power() == 0) {
    counter.add(count);
    return;
  }
  for (std::size_t done = 0; done < count && !counter.stopped(); done += starts_at_a_time) {
    const std::vector<PhotonStart> starts =
        band.sources.starts(seed_, {first, count}, done, std::min(starts_at_a_time, count - done));
    kernels_.follow_in_time(band.mesh.view(), {starts, first + done, seed_, roulette, watch_by(counter)},
                            tally);
  }
}

PhotonBatches::Hits PhotonBatches::hits(int number, std::uint64_t first, std::size_t count,
                                        StageCounter& counter) const {
  const Band& band = *bands_[static_cast<std::size_t>(number)];
  Hits hits;
  if (band.sources.power() == 0) return hits;
  std::size_t walls = 4 * starts_at_a_time, matter = 4 * starts_at_a_time;
  for (std::size_t done = 0; done < count;) {
    const std::size_t now = std::min(starts_at_a_time, count - done), old_walls = hits.walls.size(),
                      old_matter = hits.matter.size();
    hits.walls.resize(old_walls + walls);
    hits.matter.resize(old_matter + matter);
    HitBuffers buffers{{hits.walls.data() + old_walls, walls, 0},
                       {hits.matter.data() + old_matter, matter, 0}};
    const std::vector<PhotonStart> starts = band.sources.starts(seed_, {first, count}, done, now);
    kernels_.record(band.mesh.view(), {starts, first + done, seed_, roulette_of_hits, watch_by(counter)},
                    buffers);
    if (counter.stopped()) return {};
    const bool fits = buffers.walls.count <= walls && buffers.matter.count <= matter;
    hits.walls.resize(old_walls + (fits ? buffers.walls.count : 0));
    hits.matter.resize(old_matter + (fits ? buffers.matter.count : 0));
    walls = std::max(walls, buffers.walls.count);
    matter = std::max(matter, buffers.matter.count);
    // Else they are walked again, with buffers that are large enough.
    if (fits) done += now;
  }
  return hits;
}

}  // namespace etendue
