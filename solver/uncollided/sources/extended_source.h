// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <bitset>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "solver/uncollided/closed_form/emitter_tree.h"
#include "solver/uncollided/closed_form/flat_shape.h"
#include "solver/uncollided/sources/emitter_patch.h"
#include "solver/uncollided/sources/homogeneous_light.h"
#include "solver/uncollided/sources/mirrored_emitter.h"
#include "solver/uncollided/sources/shadow_planes.h"
#include "solver/uncollided/sources/wide_source.h"

namespace etendue {

/// A light with an area or a volume, with its images behind mirrors. Groups of its parts that are far away
/// shine from a few points; parts that are near are integrated over the solid angle that they fill, where
/// nothing is singular.
class ExtendedSource : public WideSource {
 public:
  using Plane = Eigen::Hyperplane<double, 3>;

  /// `power` is what the parts send in all.
  ExtendedSource(std::string name, std::vector<double> power, EmitterTree tree, const LightPaths& paths);

  void add_beams(const PointInCell& at, Sight sight, LightDetail detail, LightBeams& beams) const override;
  /// Samples the light by rays, more of them where the attenuation of neighboring rays differs.
  void sample(const PointInCell& at, LightDetail detail, VisibleRaySamples& beams) const;
  bool is_near(const Vec3& place, double size) const override;
  std::span<const EmitterPart> flat_parts() const override { return flat_parts_; }
  const ExtendedSource* as_extended() const override { return this; }
  /// Returns whether light through a homogeneous medium is summed over many parts of it that emit
  /// differently: slow, and smooth.
  bool is_in_parts() const { return body_.shapes.empty() && tree_.shape() == EmitterShape::tetrahedra; }
  double diameter() const { return tree_.box().diagonal().norm(); }
  /// In which all of it lies; none of a body or of surfaces in several planes.
  const std::optional<Plane>& plane() const { return plane_; }
  /// The sides of its rim that a place lies on but for a distance.
  std::bitset<32> rim_sides_at(const Vec3& place, double distance) const;
  /// Light that would arrive through a homogeneous medium of this extinction [band] and nothing opaque, via
  /// mirrors too, without the images behind this plane of a mirror: in closed form where the light is made of
  /// a few uniform flat shapes or bodies. `beams` is room to work in.
  void evaluate_homogeneous(const Vec3& place, std::span<const double> extinction, std::optional<int> without,
                            LightBeams& beams, HomogeneousLight& light) const;

 private:
  class VisibilitySampler;
  void find_mirrored_emitter();
  /// The images behind mirrors that do not belong to the body, without those behind this plane.
  std::vector<MirrorSet> images_of(const MirroredEmitter& body, std::optional<int> without = {}) const;
  std::vector<EmitterPatch> cut(const Vec3& place, LightDetail detail) const;
  void cut(const LightView& view, LightDetail detail, std::vector<EmitterPatch>& patches) const;
  void cut_node(const LightView& view, LightDetail detail, int index,
                std::vector<EmitterPatch>& patches) const;
  /// False, and nothing added, where there are too many shadow edges.
  bool cut_along_shadow_edges(const LightView& view, LightDetail detail,
                              std::vector<EmitterPatch>& patches) const;
  void cut_triangle(const LightView& view, LightDetail detail, const EmitterPart& part,
                    std::span<const ShadowPlane> planes, std::vector<EmitterPatch>& patches) const;
  void cut_tetrahedron(const LightView& view, LightDetail detail, const EmitterPart& part,
                       std::vector<EmitterPatch>& patches) const;
  void cut_body(const LightView& view, LightDetail detail, std::vector<EmitterPatch>& patches) const;
  void cut_wedge(const LightView& view, LightDetail detail, const EmitterPart& part, Wedge wedge,
                 std::vector<EmitterPatch>& patches) const;
  std::vector<EmitterPatch> parts_of(const EmitterPatch& patch) const;

  std::vector<LightPoint> points_of(const EmitterPatch& patch) const;
  const std::vector<double>& brightness(const EmitterPatch& patch) const;
  void add_clear(const EmitterPatch& patch, LightBeams& beams) const;
  /// Transmittance [band] of the path up to a point of the light; false where it is closed.
  bool pass(const PointInCell& at, const EmitterPatch& patch, const LightPoint& point, const Vec3& direction,
            std::span<double> passed) const;
  /// Makes the fluence that arrives of the transmitted part of the path.
  void scale(const EmitterPatch& patch, const LightPoint& point, std::span<double> fluence) const;

  void add_shapes(MirrorSet mirrors, const Vec3& eye, std::span<const double> extinction,
                  HomogeneousLight& light) const;
  /// The bands in which too little arrives to be told this way: nothing has been added to them.
  std::vector<std::size_t> add_bodies(const LightView& view, std::span<const double> extinction,
                                      HomogeneousLight& light) const;
  void add_parts(const LightView& view, std::span<const double> extinction,
                 std::span<const std::size_t> bands, LightBeams& beams, HomogeneousLight& light) const;

  EmitterTree tree_;
  const LightPaths& paths_;
  std::vector<MirrorSet> images_;
  std::vector<MirrorSet> views_;  ///< of the mirrored emitter
  std::vector<std::size_t> all_bands_;
  std::vector<EmitterPart> flat_parts_;
  std::optional<Plane> plane_;
  std::vector<std::pair<FlatShape, std::vector<double>>> shapes_;  ///< with their radiance [band]
  /// Convex only where its extinction is the same everywhere. Of triangles nothing but the box.
  MirroredEmitter body_;
  std::vector<MirroredEmitter> bodies_before_;  ///< [mirror] without the images behind it, if it has such
};

}  // namespace etendue
