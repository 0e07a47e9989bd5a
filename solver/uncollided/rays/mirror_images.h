// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/vec3.h"
#include "solver/problem/problem.h"

namespace etendue {

/// A set of mirror planes, one bit each.
using MirrorSet = std::uint32_t;

/// The planes of the mirrors, and on which of them each boundary face lies.
class MirrorPlanes {
 public:
  explicit MirrorPlanes(const Problem& problem);

  /// -1 where the face does not mirror in any band.
  int of(FaceIndex face) const { return of_face_[face.at()]; }
  bool empty() const { return planes_.empty(); }
  int count() const { return static_cast<int>(planes_.size()); }
  /// Unit.
  const Vec3& normal(int plane) const { return planes_[static_cast<std::size_t>(plane)].normal; }
  /// Of the points x of a plane: normal.x [length].
  double offset(int plane) const { return planes_[static_cast<std::size_t>(plane)].offset; }
  /// Returns whether two of them show each other again and again.
  bool are_parallel(int a, int b) const;
  Vec3 reflected(int plane, const Vec3& direction) const;
  /// Returns whether a point lies on all planes of a set to within a distance.
  bool touches(MirrorSet mirrors, const Vec3& point, double distance) const;
  /// Those of a set that a point lies behind by more than a distance.
  MirrorSet behind(MirrorSet mirrors, const Vec3& point, double distance) const;
  /// The point behind the mirrors of a set: for planes at right angles their order does not matter.
  Vec3 image(MirrorSet mirrors, Vec3 point) const;
  Vec3 image_direction(MirrorSet mirrors, Vec3 direction) const;
  /// What all mirrors of a set leave of light in a band; where a plane has several, one of them counts.
  double reflectance(MirrorSet mirrors, std::size_t band) const;

  /// All sets of planes: a light is seen once behind each. Throws InputError, naming the walls, where two
  /// planes are not at right angles: the light would be seen too often, or not in all of the mirror.
  std::vector<MirrorSet> images_of_point() const;
  /// Sets that give different directions; planes may be parallel too.
  std::vector<MirrorSet> images_of_direction() const;
  /// Throws InputError, naming the walls, where two planes that light of this direction meets are not at
  /// right angles: images_of_direction() then leaves out places in which a narrow beam is seen.
  void require_one_image_per_direction(const Vec3& direction) const;

 private:
  struct Plane {
    Vec3 normal;
    double offset;
    int wall;
  };
  void require_right_angle(const Plane& a, const Plane& b) const;

  const Problem& problem_;
  std::vector<Plane> planes_;
  std::vector<int> of_face_;
};

}  // namespace etendue
