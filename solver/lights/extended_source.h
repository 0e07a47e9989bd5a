// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/lights/emitter_tree.h"
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
  bool is_extended() const override { return true; }
  bool is_smooth_over(double size) const override {
    return tree_.shape() == EmitterShape::tetrahedra && 3 * size < tree_.box().diagonal().norm();
  }

 private:
  struct View;
  void add_node(const View& view, const EmitterTree::Node& node, LightBeams& beams) const;
  void add_points(const View& view, const EmitterTree::Node& node, LightBeams& beams) const;
  void add_triangle(const View& view, const EmitterPart& part, LightBeams& beams) const;
  void add_tetrahedron(const View& view, const EmitterPart& part, LightBeams& beams) const;

  EmitterTree tree_;
  const LightPaths& paths_;
  std::vector<MirrorSet> images_;
};

}  // namespace etendue
