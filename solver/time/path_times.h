// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "solver/time/slowness.h"
#include "solver/uncollided/lights/light_setup.h"

namespace etendue {

/// A beam of uncollided light at a point.
struct TimedBeam {
  std::size_t source;               ///< number among the sources of the lights
  Vec3 direction;                   ///< of travel
  double time;                      ///< that it has been under way [time]
  std::span<const double> fluence;  ///< [band] in steady light [power/length^2]
};

using TimedBeamReader = std::function<void(const TimedBeam&)>;

/// Beams of uncollided light with the time that they have been under way, from lamps, emitting walls and
/// media, or from where it enters the domain; mirrors included. Times are found as extinction is: each band
/// is there three times, once without them and twice attenuated by its time too, by a and 2 a for each unit
/// of it. From the logarithms of these come the mean time of a beam and the variance, where its source has a
/// depth: then half of it comes a deviation earlier and half later. So all that finds a source's beams finds
/// their times.
class PathTimes {
 public:
  /// The lights must outlive it.
  PathTimes(const LightSetup& lights, const Slowness& slowness);
  PathTimes(const PathTimes&) = delete;
  PathTimes& operator=(const PathTimes&) = delete;

  std::size_t source_count() const { return timed_.sources().size(); }
  const LightSource& source(std::size_t i) const { return *timed_.sources()[i]; }
  const LightSetup& lights() const { return lights_; }
  const Slowness& slowness() const { return slowness_; }
  /// For beams of one point at a time.
  LightBeams room() const { return LightBeams(timed_.paths().bands()); }
  /// Hands over the beams of one source at a point, or those at the finest detail, cut along shadow edges.
  void beams_at(const PointInCell& at, std::size_t source, LightDetail detail, LightBeams& room,
                const TimedBeamReader& reader) const;
  void finest_beams_at(const PointInCell& at, std::size_t source, LightBeams& room,
                       const TimedBeamReader& reader) const;

  /// Time of a beam with a cross-section at a point, as if it were wide enough to be there; empty where none
  /// of its directions leads back to a wall, or for other sources.
  std::optional<double> time_of_beam(const PointInCell& at, std::size_t source) const;

 private:
  struct Times {
    double mean, deviation;  ///< [time]
  };
  /// Of one band of a beam, by its fluence in all copies.
  Times times_of(std::span<const double> copied, std::size_t band) const;

  const LightSetup& lights_;
  Slowness slowness_;
  double rate_;       ///< a [1/time]
  Problem problem_;   ///< with each band three times
  LightSetup timed_;  ///< of that problem
};

}  // namespace etendue
