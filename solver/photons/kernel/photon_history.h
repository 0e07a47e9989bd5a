// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstring>

#include "solver/photons/kernel/photon_kernel.h"
#include "solver/photons/kernel/photon_turns.h"
#include "solver/photons/kernel/random_events.h"

namespace etendue {

/// Those that survive the roulette have this many times the weight at which it is played.
inline constexpr double survivor = 10;
inline constexpr double endless = 1e300;

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

  /// Turns if it scatters, and has the path to the next collision then. There are no branches on that: which
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

/// Path through a cell.
struct Passage {
  Four coordinate;  ///< barycentric, where it begins
  Four rate;        ///< their change for each length
  double length;
  std::int32_t exit;
};

ETENDUE_PHOTON_INLINE Passage passage_of(const PhotonCell& cell, const Photon& photon) {
  Passage passage;
  const Four gx = load(cell.gx), gy = load(cell.gy), gz = load(cell.gz);
  passage.rate = gx * photon.w[0] + gy * photon.w[1] + gz * photon.w[2];
  passage.coordinate = gx * photon.x[0] + gy * photon.x[1] + gz * photon.x[2] + load(cell.offset);
  Four distance = -passage.coordinate / passage.rate;
  const Four never = {endless, endless, endless, endless};
  distance = passage.rate < 0 ? distance : never;
  // The face that it came in by is behind it, whatever rounding says.
  using Places = long long __attribute__((vector_size(32)));
  const Places place = {0, 1, 2, 3};
  distance = place == static_cast<long long>(photon.entered) ? never : distance;
  passage.exit = place_of_least(distance, passage.length);
  passage.length = passage.length > 0 ? passage.length : 0;
  return passage;
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

/// Returns whether the photon lives on; it then weighs what those that died did.
ETENDUE_PHOTON_INLINE bool survives(Photon& photon, double roulette) {
  if (!(photon.weight > 0)) return false;
  const double target = survivor * roulette;
  std::uint32_t word[4];
  photon.random.next(word);
  if (uniform(word[0]) * target >= photon.weight) return false;
  photon.weight = target;
  return true;
}

}  // namespace etendue
