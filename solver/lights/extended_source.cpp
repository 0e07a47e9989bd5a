// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/lights/extended_source.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "mesh/tetrahedra/sheet_faces.h"
#include "solver/lights/attenuation.h"
#include "solver/lights/even_pieces.h"
#include "solver/lights/even_way.h"
#include "solver/lights/solid_angle.h"

namespace etendue {
namespace {

/// Without rays more points are cheap.
constexpr LightDetail clear_detail{0.25, 0.03, 0.3, 0.9, TriangleRule::seven_points};

/// Bodies whose radius is below this part of their distance are seen as points: what their faces bring is a
/// difference of larger numbers.
constexpr double far_in_distances = 0.1;
/// So are those of which less than this part of their size arrives.
constexpr double least_of_size = 1e-4;

/// More faces make too many pairs of a face in front and one behind.
constexpr std::size_t most_faces = 12;
/// Triangles up to which each is cut along creases.
constexpr std::size_t most_parted = 500;
/// How finely a body is looked at, and the radius in distances below which three points of a part do.
constexpr double largest_side_of_body = 0.5, small_body = 0.25;

std::span<const Vec3> triangle(const EmitterPart& part) { return std::span(part.corners).first<3>(); }

/// What one part brings is the integral over its solid angle of the brightness along each direction.
void scale(std::span<double> fluence, const std::vector<double>& brightness, double factor) {
  for (std::size_t b = 0; b < fluence.size(); ++b) fluence[b] *= brightness[b] * factor;
}

}  // namespace

/// Where the light is looked at. Through mirrors the eye is moved behind them instead of the light.
struct ExtendedSource::View {
  const PointInCell& at;
  Sight sight;
  LightDetail detail;
  MirrorSet mirrors;
  Vec3 eye;

  /// A new beam from a direction in which the moved eye looks, with the transmittance of the way up to where
  /// the light begins, and that goes on so far behind; empty where the way is closed.
  std::span<double> open_way(const LightPaths& paths, const Vec3& looking, double length, double behind,
                             LightBeams& beams) const {
    const Vec3 direction = paths.mirrors().image_direction(mirrors, looking);
    const std::span<double> fluence = beams.add(-direction, {length, behind});
    // In the light itself, on a mirror that it touches too.
    const bool is_seen_at_once = sight == Sight::clear || length == 0;
    for (std::size_t b = 0; b < fluence.size(); ++b)
      fluence[b] = is_seen_at_once ? paths.mirrors().reflectance(mirrors, b) : 1.0;
    if (is_seen_at_once || paths.transmit(at, direction, length, mirrors, fluence)) return fluence;
    beams.drop();
    return {};
  }
};

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
  } else {
    bodies_ = solid_shapes(tree_.parts());
  }
  const auto as_first = [this](const EmitterPart& part) {
    return part.extinction == tree_.part(0).extinction;
  };
  // A sheet may stand in the body.
  if (bodies_.size() == 1 && paths.matter().empty() && std::ranges::all_of(tree_.parts(), as_first) &&
      vertices_of_sheets(paths.problem().mesh()).empty())
    convex_ = bodies_[0].first.convex_faces();
  if (convex_.size() > most_faces) convex_.clear();
}

void ExtendedSource::add_beams(const PointInCell& at, Sight sight, LightDetail detail,
                               LightBeams& beams) const {
  for (const MirrorSet mirrors : images_)
    add_view({at, sight, detail, mirrors, paths_.mirrors().image(mirrors, at.position)}, beams);
}

void ExtendedSource::add_view(const View& view, LightBeams& beams) const {
  const EmitterTree::Node& root = tree_.root();
  const bool far = root.radius < view.detail.opening / 2 * (root.centre - view.eye).norm() &&
                   root.thickness < view.detail.thickness / 2;
  if (view.detail.creases != nullptr && !flat_parts_.empty() && add_parted(view, beams)) return;
  if (convex_.empty() || far)
    add_node(view, root, beams);
  else
    add_body(view, beams);
}

bool ExtendedSource::is_far(const Vec3& eye) const {
  return tree_.root().radius < far_in_distances * (tree_.root().centre - eye).norm();
}

void ExtendedSource::add_node(const View& view, const EmitterTree::Node& node, LightBeams& beams) const {
  const bool flat = tree_.shape() == EmitterShape::triangles;
  const bool simple = !flat || !node.normal.isZero();
  // All of it shines the other way.
  if (flat && simple && node.normal.dot(view.eye - node.centre) <= 0) return;
  const bool thin = node.thickness < view.detail.thickness;
  if (simple && thin && !node.hollow && node.radius < view.detail.opening * (node.centre - view.eye).norm())
    return add_points(view, node, beams);
  if (node.part < 0) {
    for (const int child : node.children) add_node(view, tree_.node(child), beams);
  } else if (flat) {
    add_triangle(view, tree_.part(node.part), {}, beams);
  } else {
    add_tetrahedron(view, tree_.part(node.part), beams);
  }
}

void ExtendedSource::add_points(const View& view, const EmitterTree::Node& node, LightBeams& beams) const {
  const bool one = node.radius < view.detail.single * (node.centre - view.eye).norm();
  const std::size_t count = one ? 1 : node.point_count;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 way = (one ? node.middle : node.points[i]) - view.eye;
    const double distance = way.norm();
    double seen = 1 / (static_cast<double>(count) * distance * distance);
    if (tree_.shape() == EmitterShape::triangles) seen *= -node.normal.dot(way) / distance;
    const std::span<double> fluence = view.open_way(paths_, way / distance, distance, 0, beams);
    if (!fluence.empty()) scale(fluence, node.total, seen);
  }
}

// Of a large triangle creases may be too many to be told apart, where they are not of each face of the mesh.
bool ExtendedSource::add_parted(const View& view, LightBeams& beams) const {
  if (flat_parts_.size() > most_parted) return false;
  const CreasePlanes creases(paths_, *view.detail.creases, view.eye, view.mirrors);
  std::vector<std::vector<CreasePlane>> planes(flat_parts_.size());
  bool told_apart = true;
  for (std::size_t i = 0; i < flat_parts_.size() && told_apart; ++i)
    told_apart = !shines_to(flat_parts_[i], view.eye) || creases.find(0, triangle(flat_parts_[i]), planes[i]);
  for (std::size_t i = 0; i < flat_parts_.size() && told_apart; ++i)
    if (shines_to(flat_parts_[i], view.eye)) add_triangle(view, flat_parts_[i], planes[i], beams);
  if (told_apart) return true;
  if (tree_.parts().size() > most_parted) return false;
  for (const EmitterPart& part : tree_.parts()) {
    if (!shines_to(part, view.eye)) continue;
    creases.find(0, triangle(part), planes[0]);
    add_triangle(view, part, planes[0], beams);
  }
  return true;
}

void ExtendedSource::add_triangle(const View& view, const EmitterPart& part,
                                  std::span<const CreasePlane> planes, LightBeams& beams) const {
  const Vec3 a = part.corners[0] - view.eye, b = part.corners[1] - view.eye, c = part.corners[2] - view.eye;
  const Vec3 normal = (b - a).cross(c - a);
  std::vector<SolidAnglePoint> points;
  for (const SphericalTriangle& seen : cut_by_planes({a, b, c}, planes))
    append_points(seen, view.detail.largest_side, view.detail.rule, points);
  for (const SolidAnglePoint& point : points) {
    const double distance = normal.dot(a) / normal.dot(point.direction);
    const std::span<double> fluence = view.open_way(paths_, point.direction, distance, 0, beams);
    if (!fluence.empty()) scale(fluence, part.brightness, point.weight);
  }
}

void ExtendedSource::add_tetrahedron(const View& view, const EmitterPart& part, LightBeams& beams) const {
  std::array<Vec3, 4> corners = part.corners;
  for (Vec3& corner : corners) corner -= view.eye;
  for (const Wedge& wedge : wedges_of(corners)) add_wedge(view, wedge, part, beams);
}

// All parts of the body are as the first.
void ExtendedSource::add_body(const View& view, LightBeams& beams) const {
  std::vector<ConvexFace> faces = convex_;
  for (ConvexFace& face : faces)
    for (Vec3& corner : face.corners) corner -= view.eye;
  View finer = view;
  const double size = tree_.root().radius / (tree_.root().centre - view.eye).norm();
  const bool fine = view.detail.rule == TriangleRule::seven_points;
  finer.detail.largest_side = std::min(view.detail.largest_side, largest_side_of_body);
  // What stands in the way may be seen sharply.
  if (fine) finer.detail.largest_side *= std::min(1.0, 2 * size);
  finer.detail.rule = !fine && size < small_body ? TriangleRule::three_points : TriangleRule::seven_points;
  for (const Wedge& wedge : wedges_of(faces)) add_wedge(finer, wedge, tree_.part(0), beams);
}

void ExtendedSource::add_wedge(const View& view, const Wedge& wedge, const EmitterPart& part,
                               LightBeams& beams) const {
  std::vector<SolidAnglePoint> points;
  append_points(wedge.directions, view.detail.largest_side, view.detail.rule, points);
  for (const SolidAnglePoint& point : points) {
    const double in = wedge.way_in(point.direction), out = wedge.way_out(point.direction);
    const std::span<double> fluence = view.open_way(paths_, point.direction, in, out - in, beams);
    if (fluence.empty()) continue;
    const RayMatter::View light =
        view.sight == Sight::clear ? RayMatter::View{} : paths_.matter().view(-point.direction);
    for (std::size_t band = 0; band < fluence.size(); ++band) {
      double extinction = view.sight == Sight::clear ? 0 : part.extinction[band];
      if (extinction > 0 && part.cell && !paths_.matter().empty())
        extinction = paths_.extinction(*part.cell, band, light);
      fluence[band] *= attenuated_way(extinction, out - in).constant;
    }
    scale(fluence, part.brightness, point.weight);
  }
}

void ExtendedSource::look_even(const Vec3& place, std::span<const double> extinction,
                               std::optional<int> without, LightBeams& beams, EvenLight& light) const {
  light.clear();
  const PointInCell here{CellIndex(0), place};  // clear sight asks no cell
  for (const MirrorSet mirrors : images_) {
    if (without && (mirrors >> *without & 1) != 0) continue;
    const Vec3 eye = paths_.mirrors().image(mirrors, place);
    if (!shapes_.empty())
      add_shapes(mirrors, eye, extinction, light);
    else if (!bodies_.empty() && !is_far(eye))
      add_parts(mirrors, here, extinction, add_bodies(mirrors, eye, extinction, light), beams, light);
    else
      add_parts(mirrors, here, extinction, all_bands_, beams, light);
  }
}

void ExtendedSource::add_parts(MirrorSet mirrors, const PointInCell& here, std::span<const double> extinction,
                               std::span<const std::size_t> bands, LightBeams& beams,
                               EvenLight& light) const {
  if (bands.empty()) return;
  beams.clear();
  add_view({here, Sight::clear, clear_detail, mirrors, paths_.mirrors().image(mirrors, here.position)},
           beams);
  for (std::size_t i = 0; i < beams.size(); ++i)
    for (const std::size_t b : bands) {
      const double arrives = beams.fluence(i)[b] * even_way(beams.way(i), extinction[b]).transmittance;
      light.fluence[b] += arrives;
      light.flux[b] += arrives * beams.direction(i);
    }
}

void ExtendedSource::add_shapes(MirrorSet mirrors, const Vec3& eye, std::span<const double> extinction,
                                EvenLight& light) const {
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

std::vector<std::size_t> ExtendedSource::add_bodies(MirrorSet mirrors, const Vec3& eye,
                                                    std::span<const double> extinction,
                                                    EvenLight& light) const {
  std::vector<std::size_t> cancelled;
  std::vector<SolidShape::View> views(bodies_.size());
  for (const std::size_t b : all_bands_) {
    bool enough = false;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const SolidShape& body = bodies_[i].first;
      if (b == 0 || extinction[b] != extinction[b - 1]) views[i] = body.from(eye, extinction[b]);
      enough = enough || views[i].fluence > least_of_size * body.size();
    }
    if (!enough) {
      cancelled.push_back(b);
      continue;
    }
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const double arrives = bodies_[i].second[b] * paths_.mirrors().reflectance(mirrors, b);
      light.fluence[b] += arrives * views[i].fluence;
      light.flux[b] += arrives * paths_.mirrors().image_direction(mirrors, views[i].flux);
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
  for (const MirrorSet mirrors : images_) {
    const Vec3 eye = paths_.mirrors().image(mirrors, place);
    before = 0;
    for (const auto& [shape, radiance] : shapes_) add(shape.sides_at(eye, distance), shape.side_count());
    for (const auto& [body, emission] : bodies_) add(body.edges_at(eye, distance), body.edge_count());
  }
  return sides;
}

bool ExtendedSource::is_near(const Vec3& place, double size) const {
  return std::any_of(images_.begin(), images_.end(), [&](MirrorSet mirrors) {
    const Vec3 eye = paths_.mirrors().image(mirrors, place);
    return tree_.box().exteriorDistance(eye) < size &&
           (bodies_.empty() || std::any_of(bodies_.begin(), bodies_.end(), [&](const auto& body) {
              return body.first.distance_to_surface(eye) < size;
            }));
  });
}

}  // namespace etendue
