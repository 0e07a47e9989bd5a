// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "solver/uncollided/closed_form/emitter_tree.h"
#include "solver/uncollided/closed_form/solid_angle.h"
#include "solver/uncollided/closed_form/solid_shape.h"
#include "solver/uncollided/rays/light_paths.h"

namespace etendue {

/// Emitter that touches perfect mirrors, joined with its images behind them (method of images): reflected
/// light travels straight from the images. A source in the corner of three
/// mirrors is a single box about it instead of eight boxes.
struct MirroredEmitter {
  MirroredEmitter() = default;
  /// Of these tetrahedra alone.
  explicit MirroredEmitter(std::span<const EmitterPart> tetrahedra);
  /// Of cells of the mesh and their images behind those of these mirrors with which its edges are still few,
  /// and with which it is convex if it is so alone.
  MirroredEmitter(const LightPaths& paths, std::span<const EmitterPart> cells, MirrorSet mirrors);

  MirrorSet across = 0;  ///< the mirrors behind which its images belong to it
  /// The uniform bodies that it consists of, with their emission [band]; empty where these have too many
  /// edges.
  std::vector<std::pair<SolidShape, std::vector<double>>> shapes;
  std::vector<ConvexFace> convex;  ///< empty where it is not one convex shape of few faces
  Eigen::AlignedBox3d box;
  double radius = 0;  ///< of a ball about the middle of the box that holds all of it [length]

  /// The radius over the distance.
  double size_from(const Vec3& eye) const { return radius / (box.center() - eye).norm(); }
};

/// The mirrors that the faces of these cells in their planes lie on, at least one each, and that send all
/// light back there.
MirrorSet mirrors_touched(const LightPaths& paths, std::span<const EmitterPart> cells);

}  // namespace etendue
