// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/vec3.h"
#include "solver/uncollided/rays/mirror_copies.h"
#include "solver/uncollided/rays/shadow_edges.h"
#include "solver/uncollided/sources/light_source.h"

namespace etendue {

/// The half of a plane behind a shadow edge, seen from a light: on normal . x = offset, between two straight
/// lines along the light through its ends. Of the edge of a lamp's cone that behind a chord of it.
struct ShadowPlane {
  struct Half {
    Vec3 normal;  ///< unit
    double offset;
    double above(const Vec3& point) const { return normal.dot(point) - offset; }
  };
  Half plane;
  Half begin, end;  ///< both positive between the ends
  double nearest;   ///< where the shadow edge begins: along the light, or from it [length]
};

/// A triangle cut along the planes whose shadow edge is seen within it, into triangles; itself if there are
/// none. Corners that a plane misses by a billionth of its size lie on it.
std::vector<std::array<Vec3, 3>> cut_by_planes(const std::array<Vec3, 3>& triangle,
                                               std::span<const ShadowPlane> planes);

/// The planes behind all shadow edges, and along the edges of a lamp's cones, for a light that is a point or
/// a beam, and for its images behind mirrors. Without planes for other lights. May be used by several threads
/// at a time.
class ShadowPlanes {
 public:
  ShadowPlanes(const LightPaths& paths, const std::vector<ShadowEdge>& shadow_edges,
               const LightSource& source);
  /// Those before which an eye sees light, via mirrors as behind them: one image.
  ShadowPlanes(const LightPaths& paths, const std::vector<ShadowEdge>& shadow_edges, const Vec3& eye,
               MirrorSet mirrors);

  /// Returns whether all are known, as they are but where there are very many or parallel mirrors show them
  /// too often.
  bool are_complete() const { return complete_; }
  /// Those that pass through a cell or a face with these corners in the light of an image, as the source
  /// numbers them, about the image's place if it has one. False where they may not be all: without any,
  /// because they are too many, or because parallel mirrors show shadow edges again and
  /// again.
  bool find(std::size_t image, std::span<const Vec3> corners, std::vector<ShadowPlane>& found) const;
  /// Those of all images, about the origin of space.
  bool find(std::span<const Vec3> corners, std::vector<ShadowPlane>& found) const;
  /// Returns whether there are any, too many included.
  bool pass_through(std::span<const Vec3> corners) const;

 private:
  struct Image {
    Vec3 place;      ///< of a point
    Vec3 direction;  ///< of a beam, zero for a point
    std::vector<ShadowPlane> planes;
    std::size_t along_rims = 0;  ///< planes among them: the last ones
  };
  void add_planes(const std::vector<ShadowEdge>& shadow_edges, const std::vector<MirrorCopy>& copies,
                  std::span<const int> lit_walls, Image& image);
  void add_rim(std::span<const Vec3> rim, Image& image);

  std::vector<Image> images_;
  bool complete_ = true;
};

}  // namespace etendue
