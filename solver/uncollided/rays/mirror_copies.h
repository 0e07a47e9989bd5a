// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "solver/uncollided/rays/light_paths.h"

namespace etendue {

/// The room as it stands behind mirrors, through which light from there comes straight.
struct MirrorCopy {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Vec3 shift = Vec3::Zero();

  Vec3 point(const Vec3& in_room) const { return turn * in_room + shift; }
  /// In the room, of light that has this one in the copy.
  Vec3 direction_in_room(const Vec3& direction) const { return turn.transpose() * direction; }
};

/// The room itself and its copies behind some of these mirrors, none of which are parallel.
std::vector<MirrorCopy> copies_behind(const MirrorPlanes& planes, MirrorSet mirrors);

/// For a beam of unit direction that comes via these mirrors; parallel ones show the room again and
/// again, as far as light gets before it must have left. Empty where that is too often.
std::vector<MirrorCopy> copies_along(const LightPaths& paths, MirrorSet mirrors, const Vec3& direction);

}  // namespace etendue
