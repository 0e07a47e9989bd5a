// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>

#include "solver/uncollided/closed_form/solid_angle.h"
#include "solver/uncollided/closed_form/uniform_emitters.h"
#include "solver/uncollided/rays/attenuation.h"
#include "solver/uncollided/sources/extended_source.h"

namespace etendue {
namespace {

/// Part of a path by which its end lies behind a mirror at most if it counts as before it: less than what
/// LightPaths::transmit allows.
constexpr double before_mirror = 1e-10;
/// Triangles up to which each is cut along shadow edges.
constexpr std::size_t most_parted = 500;
/// How finely a body is sampled, and the radius in distances below which three points of a part do.
constexpr double largest_side_of_body = 0.5, small_body = 0.25;

}  // namespace

std::vector<EmitterPatch> ExtendedSource::cut(const Vec3& place, LightDetail detail) const {
  std::vector<EmitterPatch> patches;
  for (const MirrorSet mirrors : views_)
    cut({mirrors, paths_.mirrors().image(mirrors, place), &body_}, detail, patches);
  return patches;
}

void ExtendedSource::cut(const LightView& view, LightDetail detail,
                         std::vector<EmitterPatch>& patches) const {
  const EmitterTree::Node& root = tree_.root();
  if (detail.shadow_edges != nullptr && !flat_parts_.empty() && cut_along_shadow_edges(view, detail, patches))
    return;
  const bool far =
      view.body->size_from(view.eye) < detail.opening / 2 && root.thickness < detail.thickness / 2;
  if (!far && !view.body->convex.empty()) return cut_body(view, detail, patches);
  for (const MirrorSet mirrors : images_)
    if ((mirrors & ~view.body->across) == 0)
      cut_node({view.mirrors | mirrors, paths_.mirrors().image(mirrors, view.eye), nullptr}, detail, 0,
               patches);
}

void ExtendedSource::cut_node(const LightView& view, LightDetail detail, int index,
                              std::vector<EmitterPatch>& patches) const {
  const EmitterTree::Node& node = tree_.node(index);
  const bool flat = tree_.shape() == EmitterShape::triangles;
  const bool simple = !flat || !node.normal.isZero();
  // All of it shines the other way.
  if (flat && simple && node.normal.dot(view.eye - node.centre) <= 0) return;
  const bool thin = node.thickness < detail.thickness;
  const double distance = (node.centre - view.eye).norm();
  if (simple && thin && !node.hollow && node.radius < detail.opening * distance)
    patches.push_back({view, index, nullptr, {}, {}, node.radius < detail.single * distance});
  else if (node.part < 0)
    for (const int child : node.children) cut_node(view, detail, child, patches);
  else if (flat)
    cut_triangle(view, detail, tree_.part(node.part), {}, patches);
  else
    cut_tetrahedron(view, detail, tree_.part(node.part), patches);
}

// Of a large triangle shadow edges may be too many to be told apart, where they are not of each face of the
// mesh.
bool ExtendedSource::cut_along_shadow_edges(const LightView& view, LightDetail detail,
                                            std::vector<EmitterPatch>& patches) const {
  if (flat_parts_.size() > most_parted) return false;
  const ShadowPlanes shadows(paths_, *detail.shadow_edges, view.eye, view.mirrors);
  std::vector<std::vector<ShadowPlane>> planes(flat_parts_.size());
  bool told_apart = true;
  for (std::size_t i = 0; i < flat_parts_.size() && told_apart; ++i)
    told_apart =
        !shines_to(flat_parts_[i], view.eye) || shadows.find(0, triangle_of(flat_parts_[i]), planes[i]);
  for (std::size_t i = 0; i < flat_parts_.size() && told_apart; ++i)
    cut_triangle(view, detail, flat_parts_[i], planes[i], patches);
  if (told_apart) return true;
  if (tree_.parts().size() > most_parted) return false;
  for (const EmitterPart& part : tree_.parts()) {
    if (!shines_to(part, view.eye)) continue;
    shadows.find(0, triangle_of(part), planes[0]);
    cut_triangle(view, detail, part, planes[0], patches);
  }
  return true;
}

void ExtendedSource::cut_triangle(const LightView& view, LightDetail detail, const EmitterPart& part,
                                  std::span<const ShadowPlane> planes,
                                  std::vector<EmitterPatch>& patches) const {
  if (!shines_to(part, view.eye)) return;
  const Vec3 a = part.corners[0] - view.eye, b = part.corners[1] - view.eye, c = part.corners[2] - view.eye;
  Wedge wedge;
  wedge.entry_normal = (b - a).cross(c - a);
  wedge.entry = wedge.entry_normal.dot(a);
  for (const SphericalTriangle& seen : cut_by_planes({a, b, c}, planes)) {
    wedge.directions = seen;
    cut_wedge(view, detail, part, wedge, patches);
  }
}

void ExtendedSource::cut_tetrahedron(const LightView& view, LightDetail detail, const EmitterPart& part,
                                     std::vector<EmitterPatch>& patches) const {
  std::array<Vec3, 4> corners = part.corners;
  for (Vec3& corner : corners) corner -= view.eye;
  for (const Wedge& wedge : wedges_of(corners)) cut_wedge(view, detail, part, wedge, patches);
}

// All parts of the body are as the first. With its images it is cut as finely as without them.
void ExtendedSource::cut_body(const LightView& view, LightDetail detail,
                              std::vector<EmitterPatch>& patches) const {
  std::vector<ConvexFace> faces = view.body->convex;
  for (ConvexFace& face : faces)
    for (Vec3& corner : face.corners) corner -= view.eye;
  const double size = tree_.root().radius / (view.body->box.center() - view.eye).norm();
  const bool fine = detail.rule == TriangleRule::seven_points;
  detail.largest_side = std::min(detail.largest_side, largest_side_of_body);
  // Obstacles may cast sharp shadows.
  if (fine) detail.largest_side *= std::min(1.0, 2 * size);
  detail.rule = !fine && size < small_body ? TriangleRule::three_points : TriangleRule::seven_points;
  for (const Wedge& wedge : wedges_of(faces)) cut_wedge(view, detail, tree_.part(0), wedge, patches);
}

void ExtendedSource::cut_wedge(const LightView& view, LightDetail detail, const EmitterPart& part,
                               Wedge wedge, std::vector<EmitterPatch>& patches) const {
  std::vector<SphericalTriangle> parts;
  append_parts(wedge.directions, detail.largest_side, parts);
  for (const SphericalTriangle& directions : parts) {
    wedge.directions = directions;
    patches.push_back({view, -1, &part, wedge, detail.rule});
  }
}

std::vector<LightPoint> ExtendedSource::points_of(const EmitterPatch& patch) const {
  std::vector<LightPoint> points;
  if (patch.group >= 0) {
    const EmitterTree::Node& node = tree_.node(patch.group);
    const std::size_t count = patch.one_point ? 1 : node.point_count;
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 separation = (patch.one_point ? node.middle : node.points[i]) - patch.view.eye;
      const double distance = separation.norm();
      double weight = 1 / (static_cast<double>(count) * distance * distance);
      if (tree_.shape() == EmitterShape::triangles) weight *= -node.normal.dot(separation) / distance;
      points.push_back({separation / distance, distance, 0, weight});
    }
    return points;
  }
  std::vector<SolidAnglePoint> directions;
  append_points(patch.wedge.directions, patch.rule, directions);
  for (const SolidAnglePoint& point : directions) {
    const double in = patch.wedge.distance_in(point.direction);
    const bool flat = tree_.shape() == EmitterShape::triangles;
    points.push_back(
        {point.direction, in, flat ? 0 : patch.wedge.distance_out(point.direction) - in, point.weight});
  }
  return points;
}

const std::vector<double>& ExtendedSource::brightness(const EmitterPatch& patch) const {
  return patch.group < 0 ? patch.part->brightness : tree_.node(patch.group).total;
}

void ExtendedSource::add_clear(const EmitterPatch& patch, LightBeams& beams) const {
  const MirrorSet mirrors = patch.view.mirrors;
  for (const LightPoint& point : points_of(patch)) {
    const Vec3 direction = paths_.mirrors().image_direction(mirrors, point.looking);
    const std::span<double> fluence = beams.add(-direction, {point.distance, point.length});
    const double weight = point.weight * (point.length > 0 ? point.length : 1);
    for (std::size_t b = 0; b < fluence.size(); ++b)
      fluence[b] = paths_.mirrors().reflectance(mirrors, b) * (brightness(patch)[b] * weight);
  }
}

bool ExtendedSource::pass(const PointInCell& at, const EmitterPatch& patch, const LightPoint& point,
                          const Vec3& direction, std::span<double> passed) const {
  const MirrorPlanes& planes = paths_.mirrors();
  const LightView& view = patch.view;
  // In the light itself, on a mirror that it touches too.
  if (point.distance == 0) {
    for (std::size_t b = 0; b < passed.size(); ++b) passed[b] = planes.reflectance(view.mirrors, b);
    return true;
  }
  MirrorSet mirrors = view.mirrors;
  if (view.body != nullptr)
    mirrors |= planes.behind(view.body->across, view.eye + point.distance * point.looking,
                             before_mirror * point.distance);
  return paths_.transmit(at, direction, point.distance, mirrors, passed);
}

// A volume takes a part of what it emits itself; the light has its path there, before all mirrors.
void ExtendedSource::scale(const EmitterPatch& patch, const LightPoint& point,
                           std::span<double> fluence) const {
  const bool inside = point.length > 0;
  const RayMatter::View light = inside ? paths_.matter().view(-point.looking) : RayMatter::View{};
  for (std::size_t b = 0; b < fluence.size(); ++b) {
    if (inside) {
      double extinction = patch.part->extinction[b];
      if (extinction > 0 && patch.part->cell && !paths_.matter().empty())
        extinction = paths_.extinction(*patch.part->cell, b, light);
      fluence[b] *= attenuation_integrals(extinction, point.length).constant;
    }
    fluence[b] *= brightness(patch)[b] * point.weight;
  }
}

void ExtendedSource::add_beams(const PointInCell& at, Sight sight, LightDetail detail,
                               LightBeams& beams) const {
  for (const EmitterPatch& patch : cut(at.position, detail)) {
    if (sight == Sight::clear) {
      add_clear(patch, beams);
      continue;
    }
    for (const LightPoint& point : points_of(patch)) {
      const Vec3 direction = paths_.mirrors().image_direction(patch.view.mirrors, point.looking);
      const std::span<double> fluence = beams.add(-direction, {point.distance, point.length});
      if (pass(at, patch, point, direction, fluence))
        scale(patch, point, fluence);
      else
        beams.drop();
    }
  }
}

}  // namespace etendue
