// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/photons/photon_kernel.h"

#include <cmath>
#include <cstring>
#include <new>
#include <utility>

#include "solver/photons/photon_turns.h"
#include "solver/photons/random_events.h"

namespace etendue {
namespace {

// Steps without a way forward, one behind the other, around an edge or a vertex, until a photon is given up;
// and steps of one history in all: only light caught between mirrors in a void goes on for so long.
constexpr int longest_stand = 200;
constexpr std::int64_t longest_history = 50'000'000;
// Those that survive the roulette have this many times the weight at which it is played.
constexpr double survivor = 10;
constexpr double endless = 1e300;

ETENDUE_PHOTON_INLINE void add(double* to, const Four& value) {
  const Four sum = load(to) + value;
  std::memcpy(to, &sum, sizeof sum);
}

/// A history while it is walked.
struct Photon {
  double x[3];
  double w[3];
  double weight;
  double depth;  ///< scattering optical depth until it scatters
  std::int32_t cell;
  std::int32_t entered;
  std::int32_t standing = 0;
  std::int32_t used = 0;     ///< of the events
  std::int32_t medium = -1;  ///< whose turns are at hand
  std::int64_t steps = 0;
  RandomStream random;
  EventBlock events;
  TurnBlock turns;

  ETENDUE_PHOTON_MEMBER Photon(const PhotonStart& start, const RandomStream& numbers)
      : weight(start.weight), cell(start.cell), entered(start.entered), random(numbers) {
    std::memcpy(x, start.position, sizeof x);
    std::memcpy(w, start.direction, sizeof w);
    events.draw(random);
    depth = events.depth[0];
  }

  /// Turns if it scatters, and has the way to the next collision then. There are no branches on that: which
  /// steps end in a collision cannot be foreseen, and a wrong guess costs as much as the step.
  ETENDUE_PHOTON_MEMBER void turn(const PhotonSceneView& scene, std::int32_t here, bool scatters,
                                  double rest) {
    if (scatters & (medium != here)) {
      medium = here;
      turns.find(events, scene.deflections[medium], scene.in_plane);
    }
    const int event = scatters ? used : events_at_a_time;
    if (scene.in_plane)
      turn_in_plane(w, turns.mu[event], turns.u[event]);
    else
      turn_by(w, turns.mu[event], turns.u[event], turns.v[event]);
    used += scatters;
    if (used == events_at_a_time) {
      events.draw(random);
      turns.find(events, scene.deflections[medium], scene.in_plane);
      used = 0;
    }
    depth = scatters ? events.depth[used] : rest;
  }

  /// The same where the medium draws the direction itself.
  ETENDUE_PHOTON_MEMBER void turn_by_direction(const DirectionalMedium& matter, bool scatters, double rest) {
    depth = rest;
    if (!scatters) return;
    scatter_by_direction(matter, cell, random, w);
    if (++used == events_at_a_time) {
      events.draw(random);
      medium = -1;
      used = 0;
    }
    depth = events.depth[used];
  }
};

/// Whether coefficients or turns anywhere depend on the direction: the others need not ask.
enum class Turning { by_angle, by_direction };

/// The way through a cell.
struct Passage {
  Four coordinate;  ///< barycentric, where it begins
  Four rate;        ///< their change for each length
  double length;
  std::int32_t exit;
};

ETENDUE_PHOTON_INLINE Passage passage_of(const PhotonCell& cell, const Photon& photon) {
  Passage way;
  const Four gx = load(cell.gx), gy = load(cell.gy), gz = load(cell.gz);
  way.rate = gx * photon.w[0] + gy * photon.w[1] + gz * photon.w[2];
  way.coordinate = gx * photon.x[0] + gy * photon.x[1] + gz * photon.x[2] + load(cell.offset);
  Four distance = -way.coordinate / way.rate;
  const Four never = {endless, endless, endless, endless};
  distance = way.rate < 0 ? distance : never;
  // The face that it came in by is behind it, whatever rounding says.
  using Places = long long __attribute__((vector_size(32)));
  const Places place = {0, 1, 2, 3};
  distance = place == static_cast<long long>(photon.entered) ? never : distance;
  way.exit = place_of_least(distance, way.length);
  way.length = way.length > 0 ? way.length : 0;
  return way;
}

/// Mean of exp(-x t) over 0 < t < 1, and the mean of t exp(-x t).
struct Attenuated {
  double mean, first;
};
ETENDUE_PHOTON_INLINE Attenuated attenuated(double x) {
  // Below this the series is exact to 1e-16: its next term is x^7/8!.
  if (x < 0.02) {
    constexpr double a[] = {1, 1. / 2, 1. / 6, 1. / 24, 1. / 120, 1. / 720, 1. / 5040};
    constexpr double b[] = {1. / 2, 1. / 3, 1. / 8, 1. / 30, 1. / 144, 1. / 840, 1. / 5760};
    const double y = x * x, z = y * y;
    // Alternating sums, in pairs so that they do not wait for each other.
    const double mean = (a[0] - a[1] * x) + (a[2] - a[3] * x) * y + (a[4] - a[5] * x + a[6] * y) * z;
    const double first = (b[0] - b[1] * x) + (b[2] - b[3] * x) * y + (b[4] - b[5] * x + b[6] * y) * z;
    return {mean, first};
  }
  const double left = std::exp(-x);
  const double mean = (1 - left) / x;
  return {mean, (mean - left) / x};
}

/// Whether the photon lives on; it then weighs what those that died did.
ETENDUE_PHOTON_INLINE bool survives(Photon& photon, double roulette) {
  if (!(photon.weight > 0)) return false;
  const double target = survivor * roulette;
  std::uint32_t word[4];
  photon.random.next(word);
  if (uniform(word[0]) * target >= photon.weight) return false;
  photon.weight = target;
  return true;
}

ETENDUE_PHOTON_INLINE void fetch(const void* from, std::size_t bytes) {
  for (std::size_t line = 0; line < bytes; line += 64)
    __builtin_prefetch(static_cast<const char*>(from) + line);
}

/// What a wall does with light that meets it at an angle.
struct Meeting {
  double glossy;     ///< part that the lobe reflects
  double mirrored;   ///< part
  double by_angle;   ///< part that is reflected, in so far as it depends on the angle
  double from_wall;  ///< radiance that the wall sends the other way [power/(length^2 sr)]
};

struct Forward {
  const PhotonTally& tally;

  /// Fetches what the next step will need while other histories are walked.
  ETENDUE_PHOTON_MEMBER void expect(const PhotonSceneView& scene, std::int32_t cell) {
    fetch(scene.cells + cell, sizeof(PhotonCell));
    fetch(tally.cells + 16 * static_cast<std::ptrdiff_t>(cell), 16 * sizeof(double));
  }
  ETENDUE_PHOTON_MEMBER void pass(const Photon& photon, const PhotonCell&, const Four& moments, double) {
    double* sums = tally.cells + 16 * static_cast<std::ptrdiff_t>(photon.cell);
    add(sums, moments);
    add(sums + 4, moments * photon.w[0]);
    add(sums + 8, moments * photon.w[1]);
    add(sums + 12, moments * photon.w[2]);
  }
  ETENDUE_PHOTON_MEMBER void pass_emitter(const FormulaEmitter&, const Photon&, const Four&) {}
  ETENDUE_PHOTON_MEMBER void absorb(std::int32_t cell, double power) { tally.absorbed[cell] += power; }
  ETENDUE_PHOTON_MEMBER void collide(const Photon&, bool) {}
  ETENDUE_PHOTON_MEMBER void arrive(const Photon& photon, std::int32_t face, const PhotonFace& wall,
                                    const Four& coordinate, const Meeting& meeting) {
    double* sums = tally.faces + 4 * static_cast<std::ptrdiff_t>(face);
    const double a = coordinate[wall.corner[0]], b = coordinate[wall.corner[1]],
                 c = coordinate[wall.corner[2]];
    const double share = photon.weight / (a + b + c);
    sums[0] += share * a;
    sums[1] += share * b;
    sums[2] += share * c;
    sums[3] += photon.weight * meeting.by_angle;
  }
};

struct Recording {
  HitRooms& rooms;

  ETENDUE_PHOTON_MEMBER void expect(const PhotonSceneView& scene, std::int32_t cell) {
    fetch(scene.cells + cell, sizeof(PhotonCell));
  }
  ETENDUE_PHOTON_MEMBER void pass(const Photon&, const PhotonCell&, const Four&, double) {}
  ETENDUE_PHOTON_MEMBER void pass_emitter(const FormulaEmitter&, const Photon&, const Four&) {}
  ETENDUE_PHOTON_MEMBER void absorb(std::int32_t, double) {}
  ETENDUE_PHOTON_MEMBER void collide(const Photon& photon, bool scatters) {
    if (scatters) keep(photon, photon.cell, rooms.matter);
  }
  ETENDUE_PHOTON_MEMBER void arrive(const Photon& photon, std::int32_t face, const PhotonFace& wall,
                                    const Four&, const Meeting& meeting) {
    if (wall.diffuse + wall.transmittance + meeting.glossy > 0) keep(photon, face, rooms.walls);
  }
  ETENDUE_PHOTON_MEMBER static void keep(const Photon& photon, std::int32_t place, HitRoom& room) {
    if (room.count++ >= room.room) return;
    PhotonHit& hit = room.hits[room.count - 1];
    for (int axis = 0; axis < 3; ++axis) {
      hit.position[axis] = photon.x[axis];
      hit.direction[axis] = static_cast<float>(photon.w[axis]);
    }
    hit.weight = static_cast<float>(photon.weight);
    hit.place = place;
  }
};

struct Backward {
  double score = 0;

  ETENDUE_PHOTON_MEMBER void expect(const PhotonSceneView& scene, std::int32_t cell) {
    fetch(scene.cells + cell, sizeof(PhotonCell));
  }
  ETENDUE_PHOTON_MEMBER void pass(const Photon&, const PhotonCell& cell, const Four&, double weighted) {
    score += cell.emission * weighted;
  }
  ETENDUE_PHOTON_MEMBER void pass_emitter(const FormulaEmitter& emitter, const Photon& photon,
                                          const Four& moments) {
    const double parts[4] = {moments[0], moments[1], moments[2], moments[3]};
    score += emission_along(emitter, photon.cell, photon.w, parts);
  }
  ETENDUE_PHOTON_MEMBER void absorb(std::int32_t, double) {}
  ETENDUE_PHOTON_MEMBER void collide(const Photon&, bool) {}
  ETENDUE_PHOTON_MEMBER void arrive(const Photon& photon, std::int32_t face, const PhotonFace& wall,
                                    const Four& coordinate, const Meeting& meeting) {
    score += meeting.from_wall * photon.weight;
    if (wall.sent == nullptr) return;
    const double parts[3] = {coordinate[wall.corner[0]], coordinate[wall.corner[1]],
                             coordinate[wall.corner[2]]};
    score += photon.weight * radiance_along(*wall.sent, face, photon.w, parts);
  }
};

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
                                  const Passage& way, Score& score) {
  const PhotonFace& wall = scene.faces[face];
  const Meeting meeting = meet(wall, photon.w);
  score.arrive(photon, face, wall, way.coordinate + way.rate * way.length, meeting);
  const double back = wall.diffuse + meeting.glossy, kept = back + wall.transmittance + meeting.mirrored;
  if (kept <= 0) return false;
  photon.weight *= kept;
  std::uint32_t word[4];
  photon.random.next(word);
  photon.entered = way.exit;
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
  Passage way = passage_of(cell, photon);
  if (way.length == endless) {
    ++counts.lost;
    return false;
  }
  const Matter matter = matter_of<turning>(scene, cell, photon);
  const double flight = photon.depth * matter.free_path;
  const bool scatters = flight <= way.length;
  way.length = flight < way.length ? flight : way.length;
  const Attenuated part = attenuated(matter.absorption * way.length);
  const double weighted = photon.weight * way.length;
  const double integral = weighted * part.mean;
  const Four moments = way.coordinate * integral + way.rate * (weighted * way.length * part.first);
  score.pass(photon, cell, moments, integral);
  if constexpr (turning == Turning::by_direction)
    if (const FormulaEmitter* emitter = scene.deflections[cell.deflection].emitter)
      score.pass_emitter(*emitter, photon, moments);
  photon.weight -= matter.absorption * integral;
  if constexpr (turning == Turning::by_direction) score.absorb(photon.cell, matter.absorption * integral);
  for (int axis = 0; axis < 3; ++axis) photon.x[axis] += way.length * photon.w[axis];
  ++photon.steps;
  photon.standing = way.length > 0 ? 0 : photon.standing + 1;
  const std::int32_t across = cell.across[way.exit];
  if (matter.scattering > 0) {
    const double rest = photon.depth - way.length * matter.scattering;
    score.collide(photon, scatters);
    if (turning == Turning::by_direction && matter.turns != nullptr)
      photon.turn_by_direction(*matter.turns, scatters, rest > 0 ? rest : 0);
    else
      photon.turn(scene, cell.deflection, scatters, rest > 0 ? rest : 0);
    counts.collisions += scatters;
  }
  if (!scatters & (across < 0)) {
    if (!arrive(scene, photon, -1 - across, way, score)) return false;
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
  while (alive > 0) {
    for (int place = 0; place < alive; ++place) {
      auto& score = score_of(history[place]);
      if (step<turning>(scene, range.roulette, *photon[place], score, counts)) continue;
      counts.segments += photon[place]->steps;
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

PhotonCounts record_all(const PhotonSceneView& scene, const HistoryRange& range, HitRooms& rooms) {
  Recording score{rooms};
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
  return {ETENDUE_PHOTON_KERNEL_ISA, follow_all, record_all, collect_all};
}

}  // namespace etendue
