// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/photons/kernel/photon_kernel.h"

#include <new>
#include <utility>

#include "solver/photons/kernel/photon_history.h"
#include "solver/photons/kernel/photon_scores.h"

namespace etendue {
namespace {

// Steps without a way forward, one behind the other, around an edge or a vertex, until a photon is given up;
// and steps of one history in all: only light caught between mirrors in a void takes so many.
constexpr int longest_stand = 200;
constexpr std::int64_t longest_history = 50'000'000;
// Rounds of steps between two questions to who watches: a fraction of a millisecond, which costs nothing.
constexpr int rounds_between_questions = 4096;

/// Whether coefficients or turns anywhere depend on the direction: the others need not ask.
enum class Turning { by_angle, by_direction };

ETENDUE_PHOTON_INLINE Meeting meet(const PhotonFace& wall, const double (&w)[3]) {
  const double* n = wall.normal;
  if (wall.refractive_index == 1 && wall.glossy == nullptr) return {0, wall.specular, 0, wall.radiance};
  const double cos_in = -(w[0] * n[0] + w[1] * n[1] + w[2] * n[2]);
  if (wall.glossy != nullptr) {
    const double glossy = glossy_albedo(*wall.glossy, cos_in);
    return {glossy, wall.specular, glossy, wall.radiance};
  }
  const double mirrored = part_mirrored(cos_in, wall.refractive_index);
  const double square = wall.refractive_index * wall.refractive_index;
  return {0, mirrored, mirrored, square * (1 - mirrored) * wall.radiance};
}

/// Meets a wall. Whether anything is reflected or transmitted. The glossy part is chosen by the albedo and
/// its direction weighed by what the sample is off it.
template <class Score>
ETENDUE_PHOTON_INLINE bool arrive(const PhotonSceneView& scene, Photon& photon, std::int32_t face,
                                  const Passage& passage, Score& score) {
  const PhotonFace& wall = scene.faces[face];
  const Meeting meeting = meet(wall, photon.w);
  score.arrive(photon, face, wall, passage.coordinate + passage.rate * passage.length, meeting);
  const double back = wall.diffuse + meeting.glossy, kept = back + wall.transmittance + meeting.mirrored;
  if (kept <= 0) return false;
  photon.weight *= kept;
  std::uint32_t word[4];
  photon.random.next(word);
  photon.entered = passage.exit;
  const double lot = uniform(word[0]) * kept;
  if (lot < wall.diffuse || lot >= back + wall.transmittance) {
    reflect(scene, wall, lot < wall.diffuse, word, photon.w);
    return true;
  }
  if (lot < back) {
    photon.weight *=
        reflect_glossily(*wall.glossy, wall.normal, uniform(word[1]), uniform(word[2]), photon.w) /
        meeting.glossy;
    return photon.weight > 0;
  }
  const PhotonFace& behind = scene.faces[wall.behind];
  reflect(scene, behind, true, word, photon.w);
  photon.cell = behind.cell;
  photon.entered = behind.local;
  return true;
}

/// What light meets in a cell.
struct Matter {
  double scattering, free_path, absorption;
  const DirectionalMedium* turns;  ///< null where the deflection of the cell does
};
template <Turning turning>
ETENDUE_PHOTON_INLINE Matter matter_of(const PhotonSceneView& scene, const PhotonCell& cell,
                                       const Photon& photon) {
  Matter matter{cell.scattering, cell.free_path, cell.absorption, nullptr};
  if constexpr (turning == Turning::by_direction) {
    const Deflection& deflection = scene.deflections[cell.deflection];
    if (deflection.medium == nullptr) return matter;
    const DirectedCoefficients found =
        coefficients_along(*deflection.medium, photon.cell, photon.w, scene.sense);
    matter = {found.scattering, found.scattering > 0 ? 1 / found.scattering : endless, found.absorption,
              deflection.turns_by_direction ? deflection.medium : nullptr};
  }
  return matter;
}

/// One step: to the next face or collision. Whether the photon lives on.
template <Turning turning, class Score>
ETENDUE_PHOTON_INLINE bool step(const PhotonSceneView& scene, double roulette, Photon& photon, Score& score,
                                PhotonCounts& counts) {
  const PhotonCell& cell = scene.cells[photon.cell];
  Passage passage = passage_of(cell, photon);
  if (passage.length == endless) {
    ++counts.lost;
    return false;
  }
  const Matter matter = matter_of<turning>(scene, cell, photon);
  const double flight = photon.depth * matter.free_path;
  const bool scatters = flight <= passage.length;
  passage.length = flight < passage.length ? flight : passage.length;
  const Attenuated part = attenuated(matter.absorption * passage.length);
  const double weighted = photon.weight * passage.length;
  const double integral = weighted * part.mean;
  const Four moments =
      passage.coordinate * integral + passage.rate * (weighted * passage.length * part.first);
  score.pass(photon, cell, Track{passage, matter.absorption, moments, integral});
  if (score.is_over()) return false;
  if constexpr (turning == Turning::by_direction)
    if (const FormulaEmitter* emitter = scene.deflections[cell.deflection].emitter)
      score.pass_emitter(*emitter, photon, moments);
  photon.weight -= matter.absorption * integral;
  if constexpr (turning == Turning::by_direction) score.absorb(photon.cell, matter.absorption * integral);
  for (int axis = 0; axis < 3; ++axis) photon.x[axis] += passage.length * photon.w[axis];
  ++photon.steps;
  photon.standing = passage.length > 0 ? 0 : photon.standing + 1;
  const std::int32_t across = cell.across[passage.exit];
  if (matter.scattering > 0) {
    const double rest = photon.depth - passage.length * matter.scattering;
    score.collide(photon, scatters);
    if (turning == Turning::by_direction && matter.turns != nullptr)
      photon.turn_by_direction(*matter.turns, scatters, rest > 0 ? rest : 0);
    else
      photon.turn(scene, cell.deflection, scatters, rest > 0 ? rest : 0);
    counts.collisions += scatters;
  }
  if (!scatters & (across < 0)) {
    if (!arrive(scene, photon, -1 - across, passage, score)) return false;
  } else {
    photon.cell = scatters ? photon.cell : across >> 2;
    photon.entered = scatters ? -1 : across & 3;
    score.expect(scene, photon.cell);
  }
  if (photon.standing > longest_stand || photon.steps > longest_history) {
    ++counts.lost;
    return false;
  }
  return photon.weight >= roulette || survives(photon, roulette);
}

/// Tells who watches, now and then, how many histories have ended.
class Telling {
 public:
  ETENDUE_PHOTON_MEMBER explicit Telling(const WalkWatch& watch) : watch_(watch) {}
  ETENDUE_PHOTON_MEMBER void end_one() { ++ended_; }
  /// Is called after each round; returns whether the walk continues.
  ETENDUE_PHOTON_MEMBER bool goes_on() { return ++rounds_ < rounds_between_questions || ask(); }
  bool ask() {
    const std::uint64_t ended = ended_;
    rounds_ = 0;
    ended_ = 0;
    return watch_.goes_on == nullptr || watch_.goes_on(watch_.watcher, ended);
  }

 private:
  const WalkWatch& watch_;
  std::uint64_t ended_ = 0;
  int rounds_ = 0;
};

/// Walks histories, `together` of them step by step in turn: one computes while another waits for its next
/// cell. `score_of(i)` takes what history i leaves.
template <int together, Turning turning, class ScoreOf>
ETENDUE_PHOTON_INLINE PhotonCounts walk(const PhotonSceneView& scene, const HistoryRange& range,
                                        RandomUse use, ScoreOf&& score_of) {
  PhotonCounts counts;
  const PhotonStart* start = range.starts.data();
  const std::uint64_t count = range.starts.size();
  alignas(64) unsigned char space[together][sizeof(Photon)];
  Photon* photon[together];
  std::uint64_t history[together];
  std::uint64_t next = 0;
  int alive = 0;
  const auto begin = [&](int place) {
    photon[place] = new (space[place]) Photon(start[next], RandomStream(range.seed, range.first + next, use));
    history[place] = next++;
  };
  while (alive < together && next < count) begin(alive++);
  Telling telling(range.watch);
  while (alive > 0 && telling.goes_on()) {
    for (int place = 0; place < alive; ++place) {
      auto& score = score_of(history[place]);
      if (step<turning>(scene, range.roulette, *photon[place], score, counts)) continue;
      counts.segments += photon[place]->steps;
      telling.end_one();
      if (next < count) {
        begin(place);
        continue;
      }
      --alive;
      std::swap(photon[place], photon[alive]);
      std::swap(history[place], history[alive]);
      --place;
    }
  }
  telling.ask();
  return counts;
}

constexpr int walked_together = 4;

template <class ScoreOf>
ETENDUE_PHOTON_INLINE PhotonCounts walk_in_turn(const PhotonSceneView& scene, const HistoryRange& range,
                                                RandomUse use, ScoreOf&& score_of) {
  if (scene.by_direction) return walk<walked_together, Turning::by_direction>(scene, range, use, score_of);
  return walk<walked_together, Turning::by_angle>(scene, range, use, score_of);
}

PhotonCounts follow_all(const PhotonSceneView& scene, const HistoryRange& range, const PhotonTally& tally) {
  Forward score{tally};
  return walk_in_turn(scene, range, RandomUse::flight, [&](std::uint64_t) -> Forward& { return score; });
}

PhotonCounts follow_all_in_time(const PhotonSceneView& scene, const HistoryRange& range,
                                const TimedTally& tally) {
  for (std::uint64_t i = 0; i < range.starts.size(); ++i) tally.clocks[i] = {};
  Timed score{tally};
  return walk_in_turn(scene, range, RandomUse::flight, [&](std::uint64_t i) -> Timed& {
    score.clock = tally.clocks + i;
    return score;
  });
}

PhotonCounts record_all(const PhotonSceneView& scene, const HistoryRange& range, HitBuffers& buffers) {
  Recording score{buffers};
  return walk_in_turn(scene, range, RandomUse::flight, [&](std::uint64_t) -> Recording& { return score; });
}

PhotonCounts collect_all(const PhotonSceneView& scene, const HistoryRange& range, double* scores) {
  Backward* score = reinterpret_cast<Backward*>(scores);
  for (std::uint64_t i = 0; i < range.starts.size(); ++i) scores[i] = 0;
  PhotonSceneView backwards = scene;
  backwards.sense = -1;
  return walk_in_turn(backwards, range, RandomUse::reverse,
                      [&](std::uint64_t i) -> Backward& { return score[i]; });
}

}  // namespace

PhotonKernels ETENDUE_PHOTON_KERNEL_NAME() {
  return {ETENDUE_PHOTON_KERNEL_ISA, follow_all, follow_all_in_time, record_all, collect_all};
}

}  // namespace etendue
