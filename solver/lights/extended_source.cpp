// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/lights/extended_source.h"

#include <algorithm>
#include <utility>

#include "solver/lights/attenuation.h"
#include "solver/lights/solid_angle.h"

namespace etendue {
namespace {

/// Without rays more points are cheap.
constexpr LightDetail clear_detail{0.25, 0.03, 0.3, 0.9, TriangleRule::seven_points};

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
    const std::span<double> fluence = beams.add(-direction, length + behind / 2);
    for (std::size_t b = 0; b < fluence.size(); ++b)
      fluence[b] = sight == Sight::clear ? paths.mirrors().reflectance(mirrors, b) : 1.0;
    if (sight == Sight::clear || length == 0 || paths.transmit(at, direction, length, mirrors, fluence))
      return fluence;
    beams.drop();
    return {};
  }
};

ExtendedSource::ExtendedSource(std::string name, std::vector<double> power, EmitterTree tree,
                               const LightPaths& paths)
    : WideSource(std::move(name), std::move(power)),
      tree_(std::move(tree)),
      paths_(paths),
      images_(paths.mirrors().images_of_point()) {
  if (tree_.shape() == EmitterShape::triangles) shapes_ = flat_shapes(tree_.parts());
}

void ExtendedSource::add_beams(const PointInCell& at, Sight sight, LightDetail detail,
                               LightBeams& beams) const {
  for (const MirrorSet mirrors : images_)
    add_node({at, sight, detail, mirrors, paths_.mirrors().image(mirrors, at.position)}, tree_.root(), beams);
}

void ExtendedSource::add_node(const View& view, const EmitterTree::Node& node, LightBeams& beams) const {
  const bool flat = tree_.shape() == EmitterShape::triangles;
  const bool simple = !flat || !node.normal.isZero();
  // All of it shines the other way.
  if (flat && simple && node.normal.dot(view.eye - node.centre) <= 0) return;
  // A single part is as thin as it gets.
  const bool thin = node.part >= 0 || node.thickness < view.detail.thickness;
  if (simple && thin && !node.hollow && node.radius < view.detail.opening * (node.centre - view.eye).norm())
    return add_points(view, node, beams);
  if (node.part < 0) {
    for (const int child : node.children) add_node(view, tree_.node(child), beams);
  } else if (flat) {
    add_triangle(view, tree_.part(node.part), beams);
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

void ExtendedSource::add_triangle(const View& view, const EmitterPart& part, LightBeams& beams) const {
  const Vec3 a = part.corners[0] - view.eye, b = part.corners[1] - view.eye, c = part.corners[2] - view.eye;
  const Vec3 normal = (b - a).cross(c - a);
  std::vector<SolidAnglePoint> points;
  append_points({a, b, c}, view.detail.largest_side, view.detail.rule, points);
  for (const SolidAnglePoint& point : points) {
    const double distance = normal.dot(a) / normal.dot(point.direction);
    const std::span<double> fluence = view.open_way(paths_, point.direction, distance, 0, beams);
    if (!fluence.empty()) scale(fluence, part.brightness, point.weight);
  }
}

void ExtendedSource::add_tetrahedron(const View& view, const EmitterPart& part, LightBeams& beams) const {
  std::array<Vec3, 4> corners = part.corners;
  for (Vec3& corner : corners) corner -= view.eye;
  std::vector<SolidAnglePoint> points;
  for (const Wedge& wedge : wedges_of(corners)) {
    points.clear();
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
}

void ExtendedSource::look_even(const Vec3& place, std::span<const double> extinction,
                               std::optional<int> without, LightBeams& beams, EvenLight& light) const {
  light.clear();
  const PointInCell here{CellIndex(0), place};  // clear sight asks no cell
  for (const MirrorSet mirrors : images_) {
    if (without && (mirrors >> *without & 1) != 0) continue;
    const Vec3 eye = paths_.mirrors().image(mirrors, place);
    if (!shapes_.empty()) {
      add_shapes(mirrors, eye, extinction, light);
      continue;
    }
    beams.clear();
    add_node({here, Sight::clear, clear_detail, mirrors, eye}, tree_.root(), beams);
    for (std::size_t i = 0; i < beams.size(); ++i)
      for (std::size_t b = 0; b < light.fluence.size(); ++b) {
        const double arrives = beams.fluence(i)[b] * std::exp(-extinction[b] * beams.distance(i));
        light.fluence[b] += arrives;
        light.flux[b] += arrives * beams.direction(i);
      }
  }
}

void ExtendedSource::add_shapes(MirrorSet mirrors, const Vec3& eye, std::span<const double> extinction,
                                EvenLight& light) const {
  for (const auto& [shape, radiance] : shapes_) {
    FlatShape::View view;
    for (std::size_t b = 0; b < radiance.size(); ++b) {
      if (b == 0 || extinction[b] != extinction[b - 1]) view = shape.from(eye, extinction[b]);
      const double arrives = radiance[b] * paths_.mirrors().reflectance(mirrors, b);
      light.fluence[b] += arrives * view.solid_angle;
      light.flux[b] += arrives * paths_.mirrors().image_direction(mirrors, view.flux);
    }
  }
}

std::bitset<32> ExtendedSource::rim_sides_at(const Vec3& place, double distance) const {
  std::bitset<32> sides;
  for (const MirrorSet mirrors : images_) {
    std::size_t before = 0;
    for (const auto& [shape, radiance] : shapes_) {
      for (const std::size_t side : shape.sides_at(paths_.mirrors().image(mirrors, place), distance))
        sides.set(before + side);
      before += shape.side_count();
    }
  }
  return sides;
}

bool ExtendedSource::is_near(const Vec3& place, double size) const {
  return std::any_of(images_.begin(), images_.end(), [&](MirrorSet mirrors) {
    return tree_.box().exteriorDistance(paths_.mirrors().image(mirrors, place)) < size;
  });
}

}  // namespace etendue
