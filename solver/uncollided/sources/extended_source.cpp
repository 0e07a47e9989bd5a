// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/sources/extended_source.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "mesh/tetrahedra/sheet_faces.h"
#include "solver/uncollided/closed_form/uniform_emitters.h"
#include "solver/uncollided/sources/homogeneous_path.h"

namespace etendue {
namespace {

/// Without rays more points are cheap.
constexpr LightDetail clear_detail{0.25, 0.03, 0.3, 0.9, TriangleRule::seven_points};

/// Bodies whose radius is below this part of their distance are seen as points: what their faces bring is a
/// difference of larger numbers.
constexpr double far_in_distances = 0.1;
/// So are those of which less than this part of their size arrives.
constexpr double least_of_size = 1e-4;
/// Of the size of a light: parts that are no farther from a plane lie in it.
constexpr double part_in_plane = 1e-9;

std::optional<ExtendedSource::Plane> common_plane(std::span<const EmitterPart> flat) {
  if (flat.empty()) return {};
  Eigen::AlignedBox3d box;
  for (const EmitterPart& part : flat)
    for (const Vec3& corner : triangle_of(part)) box.extend(corner);
  const auto first = triangle_of(flat.front());
  const auto plane = ExtendedSource::Plane::Through(first[0], first[1], first[2]);
  const double allowed = part_in_plane * box.diagonal().norm();
  for (const EmitterPart& part : flat)
    for (const Vec3& corner : triangle_of(part))
      if (plane.absDistance(corner) > allowed) return {};
  return plane;
}

}  // namespace

ExtendedSource::ExtendedSource(std::string name, std::vector<double> power, EmitterTree tree,
                               const LightPaths& paths)
    : WideSource(std::move(name), std::move(power)),
      tree_(std::move(tree)),
      paths_(paths),
      images_(paths.mirrors().images_of_point()),
      all_bands_(paths.bands()) {
  std::iota(all_bands_.begin(), all_bands_.end(), 0);
  if (tree_.shape() == EmitterShape::triangles) {
    shapes_ = flat_shapes(tree_.parts());
    flat_parts_ = few_triangles(tree_.parts());
    plane_ = common_plane(flat_parts_);
    body_.box = tree_.box();
  } else {
    find_mirrored_emitter();
  }
  views_ = images_of(body_);
}

// Where extinction is not the same everywhere, or a sheet may be in it, the emitter is sampled in parts.
void ExtendedSource::find_mirrored_emitter() {
  const MirrorSet touched = mirrors_touched(paths_, tree_.parts());
  body_ = MirroredEmitter(paths_, tree_.parts(), touched);
  bodies_before_.resize(static_cast<std::size_t>(paths_.mirrors().count()));
  for (std::size_t plane = 0; plane < bodies_before_.size(); ++plane)
    if ((body_.across >> plane & 1) != 0)
      bodies_before_[plane] = MirroredEmitter(paths_, tree_.parts(), body_.across & ~(MirrorSet{1} << plane));
  const auto as_first = [this](const EmitterPart& part) {
    return part.extinction == tree_.part(0).extinction;
  };
  if (paths_.matter().empty() && std::ranges::all_of(tree_.parts(), as_first) &&
      vertices_of_sheets(paths_.problem().mesh()).empty())
    return;
  body_.convex.clear();
  for (MirroredEmitter& body : bodies_before_) body.convex.clear();
}

std::vector<MirrorSet> ExtendedSource::images_of(const MirroredEmitter& body,
                                                 std::optional<int> without) const {
  std::vector<MirrorSet> images;
  for (const MirrorSet mirrors : images_)
    if ((mirrors & body.across) == 0 && !(without && (mirrors >> *without & 1) != 0))
      images.push_back(mirrors);
  return images;
}

void ExtendedSource::evaluate_homogeneous(const Vec3& place, std::span<const double> extinction,
                                          std::optional<int> without, LightBeams& beams,
                                          HomogeneousLight& light) const {
  light.clear();
  const bool in_part = without && (body_.across >> *without & 1) != 0;
  const MirroredEmitter& body = in_part ? bodies_before_[static_cast<std::size_t>(*without)] : body_;
  for (const MirrorSet mirrors : images_of(body, without)) {
    const LightView view{mirrors, paths_.mirrors().image(mirrors, place), &body};
    if (!shapes_.empty())
      add_shapes(mirrors, view.eye, extinction, light);
    else if (!body.shapes.empty() && body.size_from(view.eye) > far_in_distances)
      add_parts(view, extinction, add_bodies(view, extinction, light), beams, light);
    else
      add_parts(view, extinction, all_bands_, beams, light);
  }
}

void ExtendedSource::add_parts(const LightView& view, std::span<const double> extinction,
                               std::span<const std::size_t> bands, LightBeams& beams,
                               HomogeneousLight& light) const {
  if (bands.empty()) return;
  std::vector<EmitterPatch> patches;
  cut(view, clear_detail, patches);
  beams.clear();
  for (const EmitterPatch& patch : patches) add_clear(patch, beams);
  for (std::size_t i = 0; i < beams.size(); ++i)
    for (const std::size_t b : bands) {
      const double arrives =
          beams.fluence(i)[b] * homogeneous_path(beams.interval(i), extinction[b]).transmittance;
      light.fluence[b] += arrives;
      light.flux[b] += arrives * beams.direction(i);
    }
}

void ExtendedSource::add_shapes(MirrorSet mirrors, const Vec3& eye, std::span<const double> extinction,
                                HomogeneousLight& light) const {
  for (const auto& [shape, radiance] : shapes_) {
    FlatShape::View view;
    for (std::size_t b = 0; b < radiance.size(); ++b) {
      if (b == 0 || extinction[b] != extinction[b - 1]) view = shape.from(eye, extinction[b]);
      const double arrives = radiance[b] * paths_.mirrors().reflectance(mirrors, b);
      light.fluence[b] += arrives * view.fluence;
      light.flux[b] += arrives * paths_.mirrors().image_direction(mirrors, view.flux);
    }
  }
}

std::vector<std::size_t> ExtendedSource::add_bodies(const LightView& view, std::span<const double> extinction,
                                                    HomogeneousLight& light) const {
  const auto& bodies = view.body->shapes;
  std::vector<std::size_t> cancelled;
  std::vector<SolidShape::View> views(bodies.size());
  for (const std::size_t b : all_bands_) {
    bool enough = false;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const SolidShape& body = bodies[i].first;
      if (b == 0 || extinction[b] != extinction[b - 1]) views[i] = body.from(view.eye, extinction[b]);
      enough = enough || views[i].fluence > least_of_size * body.size();
    }
    if (!enough) {
      cancelled.push_back(b);
      continue;
    }
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const double arrives = bodies[i].second[b] * paths_.mirrors().reflectance(view.mirrors, b);
      light.fluence[b] += arrives * views[i].fluence;
      light.flux[b] += arrives * paths_.mirrors().image_direction(view.mirrors, views[i].flux);
    }
  }
  return cancelled;
}

std::bitset<32> ExtendedSource::rim_sides_at(const Vec3& place, double distance) const {
  std::bitset<32> sides;
  std::size_t before = 0;
  const auto add = [&](const std::vector<std::size_t>& found, std::size_t count) {
    for (const std::size_t side : found)
      if (before + side < sides.size()) sides.set(before + side);
    before += count;
  };
  for (const MirrorSet mirrors : views_) {
    const Vec3 eye = paths_.mirrors().image(mirrors, place);
    before = 0;
    for (const auto& [shape, radiance] : shapes_) add(shape.sides_at(eye, distance), shape.side_count());
    for (const auto& [body, emission] : body_.shapes) add(body.edges_at(eye, distance), body.edge_count());
  }
  return sides;
}

bool ExtendedSource::is_near(const Vec3& place, double size) const {
  return std::ranges::any_of(views_, [&](MirrorSet mirrors) {
    const Vec3 eye = paths_.mirrors().image(mirrors, place);
    return body_.box.exteriorDistance(eye) < size &&
           (body_.shapes.empty() || std::ranges::any_of(body_.shapes, [&](const auto& body) {
              return body.first.distance_to_surface(eye) < size;
            }));
  });
}

}  // namespace etendue
