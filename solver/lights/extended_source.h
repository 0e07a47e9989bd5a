// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "solver/lights/clear_light.h"
#include "solver/lights/emitter_tree.h"
#include "solver/lights/flat_shape.h"
#include "solver/lights/light_source.h"

namespace etendue {

/// A light with an area or a volume, with its images behind mirrors. Groups of its parts that are far away
/// shine from a few points; parts that are near are integrated over the solid angle that they fill, where
/// nothing is singular.
class ExtendedSource : public LightSource {
 public:
  /// `power` is what the parts send in all.
  ExtendedSource(std::string name, std::vector<double> power, EmitterTree tree, const LightPaths& paths);

  void add_beams(const PointInCell& at, Sight sight, LightDetail detail, LightBeams& beams) const override;
  bool is_near(const Vec3& place, double size) const override;
  const ExtendedSource* as_extended() const override { return this; }
  /// Whether its fluence has no steps: that of a surface jumps at its rim.
  bool is_volume() const { return tree_.shape() == EmitterShape::tetrahedra; }
  /// The diagonal of a box around it.
  double size() const { return tree_.box().diagonal().norm(); }

  /// What would arrive in empty space, by way of mirrors too, without the images behind this plane of a
  /// mirror. In closed form where the light is made of a few even flat shapes.
  void look_clear(const Vec3& place, std::optional<int> without, LightBeams& beams, ClearLight& light) const;

 private:
  struct View;
  void add_node(const View& view, const EmitterTree::Node& node, LightBeams& beams) const;
  void add_shapes(MirrorSet mirrors, const Vec3& eye, ClearLight& light) const;
  void add_points(const View& view, const EmitterTree::Node& node, LightBeams& beams) const;
  void add_triangle(const View& view, const EmitterPart& part, LightBeams& beams) const;
  void add_tetrahedron(const View& view, const EmitterPart& part, LightBeams& beams) const;

  EmitterTree tree_;
  const LightPaths& paths_;
  std::vector<MirrorSet> images_;
  std::vector<std::pair<FlatShape, std::vector<double>>> shapes_;  ///< radiance [band]; empty: use the tree
};

}  // namespace etendue
