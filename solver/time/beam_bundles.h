// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "solver/problem/phase_list.h"
#include "solver/time/path_times.h"
#include "solver/uncollided/projection/uncollided_field.h"

namespace etendue {

/// Beams of one source that arrive together.
struct BeamBundle {
  std::int32_t source;
  /// Number of the direction of CollisionField from which it scatters; -1: all of it.
  std::int32_t incident;
  double time;
  double spread;
};

/// In a cell or face.
struct BundledBeams {
  std::vector<BeamBundle> bundles;  ///< by rising incident number
  std::vector<double> weights;      ///< [bundle][node][band]
};

/// Gathers the beams of one cell or face; of one thread.
class BeamBundler {
 public:
  /// The arguments must outlive it; `steady` is the field of these sources.
  BeamBundler(const PathTimes& times, const UncollidedField& steady, std::span<const std::size_t> sources);

  BundledBeams cell(CellIndex cell);
  BundledBeams face(FaceIndex face);

 private:
  void begin();
  void add(const TimedBeam& beam, std::span<const double> shape, double measure);
  void add_scattering(CellIndex cell, const Vec3& direction, const Vec3& position);
  /// Adds beams of a source to the place, in intervals of their times; by direction in a cell.
  void bundle(std::size_t source, double across, const CellIndex* by_direction);
  /// On the finest grid of which the cell has the directions around this one; empty where it has them of
  /// none.
  std::optional<OctahedralGrid::Weights> weights_of(const Vec3& direction,
                                                    std::span<const std::int32_t> known) const;
  /// The bundle of an incident number and an interval of times of the source at hand.
  std::size_t open(const std::pair<std::int32_t, std::int64_t>& key, std::int32_t source, std::size_t length);
  /// Adds weights, times a factor and another one [band]; the time is the sum until all are in.
  void add_weights(std::size_t bundle, std::span<const double> weights, double time, double factor,
                   std::span<const double> of_band);
  BundledBeams finished();

  struct Arrival {
    Vec3 direction;
    double time;
  };

  const PathTimes& times_;
  const UncollidedField& steady_;
  std::span<const std::size_t> sources_;
  std::size_t bands_;
  PhaseList phases_;
  const RayMatter& matter_;
  LightBeams room_;
  double spread_ = 0;               ///< of times in the part of a place that a point has
  std::vector<Arrival> arrivals_;   ///< of one source
  std::vector<double> weights_;     ///< [arrival][node][band]
  std::vector<double> scattering_;  ///< [arrival][band]; empty where it does not matter by direction
  BundledBeams place_;
  std::vector<double> totals_;                                         ///< [bundle] all weights
  std::map<std::pair<std::int32_t, std::int64_t>, std::size_t> open_;  ///< bundles of one source
};

}  // namespace etendue
