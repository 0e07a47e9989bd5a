// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/lights/light_source.h"

namespace etendue {

/// What light of a source that comes from many directions meets in matter that depends on them: the mean over
/// the directions in which it comes to the vertices.
class VertexLosses {
 public:
  /// The paths must outlive it.
  VertexLosses(const LightPaths& paths, const LightSource& source, int threads);

  /// At a corner of a cell whose region depends on the direction.
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
