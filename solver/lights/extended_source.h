// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <bitset>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "solver/lights/crease_planes.h"
#include "solver/lights/emitter_tree.h"
#include "solver/lights/even_light.h"
#include "solver/lights/flat_shape.h"
#include "solver/lights/solid_shape.h"
#include "solver/lights/wide_source.h"

namespace etendue {

/// A light with an area or a volume, with its images behind mirrors. Groups of its parts that are far away
/// shine from a few points; parts that are near are integrated over the solid angle that they fill, where
/// nothing is singular.
class ExtendedSource : public WideSource {
 public:
  /// `power` is what the parts send in all.
  ExtendedSource(std::string name, std::vector<double> power, EmitterTree tree, const LightPaths& paths);

  void add_beams(const PointInCell& at, Sight sight, LightDetail detail, LightBeams& beams) const override;
  bool is_near(const Vec3& place, double size) const override;
  std::span<const EmitterPart> flat_parts() const override { return flat_parts_; }
  const ExtendedSource* as_extended() const override { return this; }
  /// Whether light through even matter is added up from many parts of it, emitting each in its own way: slow,
  /// and without steps.
  bool is_in_parts() const { return bodies_.empty() && tree_.shape() == EmitterShape::tetrahedra; }
  /// The sides of its rim that a place lies on but for a distance.
  std::bitset<32> rim_sides_at(const Vec3& place, double distance) const;
  /// What would arrive through matter of this extinction [band] and nothing opaque, by way of mirrors too,
  /// without the images behind this plane of a mirror: in closed form where the light is made of a few even
  /// flat shapes or bodies. `beams` is room to work in.
  void look_even(const Vec3& place, std::span<const double> extinction, std::optional<int> without,
                 LightBeams& beams, EvenLight& light) const;

 private:
  struct View;
  bool is_far(const Vec3& eye) const;
  void add_view(const View& view, LightBeams& beams) const;
  void add_node(const View& view, const EmitterTree::Node& node, LightBeams& beams) const;
  void add_shapes(MirrorSet mirrors, const Vec3& eye, std::span<const double> extinction,
                  EvenLight& light) const;
  /// The bands in which too little arrives to be told this way: nothing has been added to them.
  std::vector<std::size_t> add_bodies(MirrorSet mirrors, const Vec3& eye, std::span<const double> extinction,
                                      EvenLight& light) const;
  void add_parts(MirrorSet mirrors, const PointInCell& here, std::span<const double> extinction,
                 std::span<const std::size_t> bands, LightBeams& beams, EvenLight& light) const;
  void add_points(const View& view, const EmitterTree::Node& node, LightBeams& beams) const;
  void add_triangle(const View& view, const EmitterPart& part, std::span<const CreasePlane> planes,
                    LightBeams& beams) const;
  /// False, and nothing added, where they are too many.
  bool add_parted(const View& view, LightBeams& beams) const;
  void add_tetrahedron(const View& view, const EmitterPart& part, LightBeams& beams) const;
  void add_wedge(const View& view, const Wedge& wedge, const EmitterPart& part, LightBeams& beams) const;
  void add_body(const View& view, LightBeams& beams) const;

  EmitterTree tree_;
  const LightPaths& paths_;
  std::vector<MirrorSet> images_;
  std::vector<std::size_t> all_bands_;
  std::vector<EmitterPart> flat_parts_;
  /// With their radiance or emission [band]; both empty: use the tree.
  std::vector<std::pair<FlatShape, std::vector<double>>> shapes_;
  std::vector<std::pair<SolidShape, std::vector<double>>> bodies_;
  std::vector<ConvexFace> convex_;  ///< of the body if there is one, of the same extinction everywhere
};

}  // namespace etendue
