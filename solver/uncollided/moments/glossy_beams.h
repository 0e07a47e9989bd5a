// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "solver/uncollided/sources/light_source.h"

namespace etendue {

/// The directions in which lights reach glossy walls, at the corners of their faces. Light that falls between
/// the corners counts at each of them, with its mean over parts of the face; a corner that is dark has the
/// beams of the unshaded lights, or those of the other corners.
class GlossyBeams {
 public:
  GlossyBeams() = default;
  GlossyBeams(const LightPaths& paths, const LightSources& sources, int threads);

  bool empty() const { return corners_.empty(); }
  /// The same beams in other bands, each as the one of these whose number it has.
  GlossyBeams of_bands(std::span<const int> bands) const;
  const std::vector<std::int32_t>& faces() const { return faces_; }  ///< boundary faces that are glossy
  /// The place of a face among faces(), -1 where it is not glossy.
  std::int32_t place_of(FaceIndex face) const { return corners_.empty() ? -1 : place_of_[face.at()]; }
  /// Beams that arrive at a corner 0, 1, 2 of the face at a place: fluence of each beam is its irradiance
  /// there.
  const LightBeams& arriving(std::size_t place, std::size_t corner) const {
    return corners_[3 * place + corner];
  }
  /// Of the light that arrives there, the part that is reflected glossily.
  double albedo(const Problem& problem, std::size_t place, std::size_t corner, std::size_t band) const;

 private:
  std::vector<std::int32_t> faces_;
  std::vector<std::int32_t> place_of_;  ///< [boundary face]
  std::vector<LightBeams> corners_;     ///< [place][corner]
};

}  // namespace etendue
