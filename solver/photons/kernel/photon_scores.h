// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstring>

#include "solver/photons/kernel/photon_history.h"

namespace etendue {

// Scores of histories along their paths: each score receives cells, collisions and walls, and may end a
// history.

/// What light does on its way through a cell.
struct Track {
  const Passage& passage;
  double absorption;  ///< [1/length]
  Four moments;       ///< integrals of weight × barycentric coordinate
  double integral;    ///< of the weight
};

ETENDUE_PHOTON_INLINE void add(double* to, const Four& value) {
  const Four sum = load(to) + value;
  std::memcpy(to, &sum, sizeof sum);
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

/// Sums in cells and on faces.
struct Forward {
  const PhotonTally& tally;

  /// Fetches what the next step will need while other histories are walked.
  ETENDUE_PHOTON_MEMBER void expect(const PhotonSceneView& scene, std::int32_t cell) {
    fetch(scene.cells + cell, sizeof(PhotonCell));
    fetch(tally.cells + 16 * static_cast<std::ptrdiff_t>(cell), 16 * sizeof(double));
  }
  ETENDUE_PHOTON_MEMBER void pass(const Photon& photon, const PhotonCell&, const Track& track) {
    const Four& moments = track.moments;
    double* sums = tally.cells + 16 * static_cast<std::ptrdiff_t>(photon.cell);
    add(sums, moments);
    add(sums + 4, moments * photon.w[0]);
    add(sums + 8, moments * photon.w[1]);
    add(sums + 12, moments * photon.w[2]);
  }
  ETENDUE_PHOTON_MEMBER void pass_emitter(const FormulaEmitter&, const Photon&, const Four&) {}
  ETENDUE_PHOTON_MEMBER void absorb(std::int32_t cell, double power) { tally.absorbed[cell] += power; }
  ETENDUE_PHOTON_MEMBER void collide(const Photon&, bool) {}
  ETENDUE_PHOTON_MEMBER static constexpr bool is_over() { return false; }
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

/// Sums by time, of one history at a time.
struct Timed {
  const TimedTally& tally;
  PhotonClock* clock = nullptr;

  ETENDUE_PHOTON_MEMBER void expect(const PhotonSceneView& scene, std::int32_t cell) {
    fetch(scene.cells + cell, sizeof(PhotonCell));
  }
  /// The part of the track in each bin.
  ETENDUE_PHOTON_MEMBER void pass(const Photon& photon, const PhotonCell& cell, const Track& track) {
    const double slowness = tally.slowness[cell.deflection], length = track.passage.length;
    const double begin = clock->time;
    while (clock->bin < tally.bins && tally.edges[clock->bin + 1] <= begin) ++clock->bin;
    clock->time = begin + slowness * length;
    for (double from = 0; from < length; ++clock->bin) {
      if (clock->bin == tally.bins) return;
      const double edge = (tally.edges[clock->bin + 1] - begin) / slowness;
      const double to = edge < length ? edge : length;
      if (clock->bin >= 0) add_part(photon, cell.deflection, track, from, to - from);
      if (to == length) return;
      from = to;
    }
  }
  ETENDUE_PHOTON_MEMBER void add_part(const Photon& photon, std::int32_t region, const Track& track,
                                      double from, double length) {
    const double weight = photon.weight * std::exp(-track.absorption * from);
    const Attenuated part = attenuated(track.absorption * length);
    const double integral = weight * length * part.mean;
    double* sums = tally.regions + 2 * (region * tally.bins + clock->bin);
    sums[0] += integral;
    sums[1] += track.absorption * integral;
    const std::int32_t place = tally.place_of_cell[photon.cell];
    if (place < 0) return;
    const Four coordinate = track.passage.coordinate + track.passage.rate * from;
    add(tally.places + 4 * (place * tally.bins + clock->bin),
        coordinate * integral + track.passage.rate * (weight * length * length * part.first));
  }
  ETENDUE_PHOTON_MEMBER void pass_emitter(const FormulaEmitter&, const Photon&, const Four&) {}
  ETENDUE_PHOTON_MEMBER void absorb(std::int32_t, double) {}
  ETENDUE_PHOTON_MEMBER void collide(const Photon&, bool) {}
  ETENDUE_PHOTON_MEMBER bool is_over() const { return clock->bin == tally.bins; }
  ETENDUE_PHOTON_MEMBER void arrive(const Photon& photon, std::int32_t face, const PhotonFace&, const Four&,
                                    const Meeting&) {
    if (clock->bin >= 0) tally.walls[tally.wall_of_face[face] * tally.bins + clock->bin] += photon.weight;
  }
};

/// Hits, for a photon map.
struct Recording {
  HitBuffers& buffers;

  ETENDUE_PHOTON_MEMBER void expect(const PhotonSceneView& scene, std::int32_t cell) {
    fetch(scene.cells + cell, sizeof(PhotonCell));
  }
  ETENDUE_PHOTON_MEMBER void pass(const Photon&, const PhotonCell&, const Track&) {}
  ETENDUE_PHOTON_MEMBER void pass_emitter(const FormulaEmitter&, const Photon&, const Four&) {}
  ETENDUE_PHOTON_MEMBER void absorb(std::int32_t, double) {}
  ETENDUE_PHOTON_MEMBER void collide(const Photon& photon, bool scatters) {
    if (scatters) keep(photon, photon.cell, buffers.matter);
  }
  ETENDUE_PHOTON_MEMBER static constexpr bool is_over() { return false; }
  ETENDUE_PHOTON_MEMBER void arrive(const Photon& photon, std::int32_t face, const PhotonFace& wall,
                                    const Four&, const Meeting& meeting) {
    if (wall.diffuse + wall.transmittance + meeting.glossy > 0) keep(photon, face, buffers.walls);
  }
  ETENDUE_PHOTON_MEMBER static void keep(const Photon& photon, std::int32_t place, HitBuffer& buffer) {
    if (buffer.count++ >= buffer.capacity) return;
    PhotonHit& hit = buffer.hits[buffer.count - 1];
    for (int axis = 0; axis < 3; ++axis) {
      hit.position[axis] = photon.x[axis];
      hit.direction[axis] = static_cast<float>(photon.w[axis]);
    }
    hit.weight = static_cast<float>(photon.weight);
    hit.place = place;
  }
};

/// What a history that goes back collects.
struct Backward {
  double score = 0;

  ETENDUE_PHOTON_MEMBER void expect(const PhotonSceneView& scene, std::int32_t cell) {
    fetch(scene.cells + cell, sizeof(PhotonCell));
  }
  ETENDUE_PHOTON_MEMBER void pass(const Photon&, const PhotonCell& cell, const Track& track) {
    const Four& moments = track.moments;
    score += cell.emission * track.integral + cell.slope[0] * (moments[1] - moments[0]) +
             cell.slope[1] * (moments[2] - moments[0]) + cell.slope[2] * (moments[3] - moments[0]);
  }
  ETENDUE_PHOTON_MEMBER void pass_emitter(const FormulaEmitter& emitter, const Photon& photon,
                                          const Four& moments) {
    const double parts[4] = {moments[0], moments[1], moments[2], moments[3]};
    score += emission_along(emitter, photon.cell, photon.w, parts);
  }
  ETENDUE_PHOTON_MEMBER void absorb(std::int32_t, double) {}
  ETENDUE_PHOTON_MEMBER void collide(const Photon&, bool) {}
  ETENDUE_PHOTON_MEMBER static constexpr bool is_over() { return false; }
  ETENDUE_PHOTON_MEMBER void arrive(const Photon& photon, std::int32_t face, const PhotonFace& wall,
                                    const Four& coordinate, const Meeting& meeting) {
    score += meeting.from_wall * photon.weight;
    if (wall.sent == nullptr) return;
    const double parts[3] = {coordinate[wall.corner[0]], coordinate[wall.corner[1]],
                             coordinate[wall.corner[2]]};
    score += photon.weight * radiance_along(*wall.sent, face, photon.w, parts);
  }
};

}  // namespace etendue
