// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/log.h"
#include "mesh/geometry/primitives/surface_complex.h"

namespace etendue {

/// What TetGen makes of a surface. Regions and walls are those of the surface; -1 where there is none.
struct TetGenMesh {
  std::vector<double> coordinates;      ///< [point][axis] [length]
  std::vector<std::int32_t> cells;      ///< [cell][4] points
  std::vector<std::int32_t> regions;    ///< [cell]
  std::vector<std::int32_t> triangles;  ///< [triangle][3] points
  std::vector<std::int32_t> walls;      ///< [triangle] -1: none
  std::vector<std::int32_t> sheets;     ///< [triangle] -1: none
};

/// The codes that TetGen gives up with (Si 2015, and tetgen.h, terminatetetgen).
enum class TetGenEnd {
  done = 0,
  out_of_memory = 1,
  internal_error = 2,
  self_intersection = 3,
  small_feature = 4,
  close_facets = 5,
  input_error = 10,
  killed = -1,       ///< it stopped on an assertion or a signal
  interrupted = -2,  ///< SIGINT or SIGTERM
  out_of_time = -3,  ///< its refinement need not end
  point_limit = -4,  ///< it has added as many points as it might
};

struct TetGenOutcome {
  TetGenEnd end = TetGenEnd::done;
  double most_seconds = 0;   ///< of the processor that it might take
  std::string last_words;    ///< what it printed last
  std::string last_warning;  ///< the last line that begins with "Warning:"
  TetGenMesh mesh;
};

/// At the largest number of points TetGen refines no more; then it would optimize for several times as long.
enum class AtPointLimit { stop, go_on };

/// Calls TetGen with its switches. max_volume is [region], 0 where there is no bound.
/// The time grows with the points of the surface and the largest number of points that the switches add.
TetGenOutcome call_tetgen(const SurfaceComplex& surface, const std::vector<double>& max_volume,
                          const std::string& switches, int most_added, const Log& log,
                          AtPointLimit at_limit = AtPointLimit::stop);

}  // namespace etendue
