// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/lights/light_source.h"

namespace etendue {

/// What light of a source with an extent meets at the corners of cells: in matter that depends on the
/// direction, which soft light alone is asked for, the mean over those in which it comes to them.
class VertexLosses {
 public:
  /// The paths must outlive it.
  VertexLosses(const LightPaths& paths, const LightSource& source, int threads);

  /// At a corner of a cell.
  PathCoefficients at(CellIndex cell, std::size_t corner, std::size_t band) const;

 private:
  struct Beam {
    RayMatter::View view;
    std::vector<double> share;  ///< [band] of the fluence
  };

  const LightPaths& paths_;
  std::vector<std::vector<Beam>> beams_;  ///< [vertex]
};

}  // namespace etendue
