// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/visibility/occluding_edges.h"

#include <algorithm>
#include <array>

#include "solver/uncollided/rays/mirror_copies.h"

namespace etendue {
namespace {

/// Edges, with their images, that are tested for each cell and face.
constexpr std::size_t most_occluding_edges = 2000;
/// Corners of a light of which all are tested; of more those of its box are.
constexpr std::size_t most_corners = 8;
/// Part of the hull's size by which an edge has to reach into it: those of a face itself touch it.
constexpr double touching = 1e-9;
/// Remainder of 1 in the cosine between the normal of one wall and the other wall where they meet at a
/// right angle.
constexpr double right_angle = 1e-9;

bool is_of_walls(const ShadowEdge& edge) {
  return std::ranges::any_of(edge.surfaces, [](const auto& surface) { return surface.wall >= 0; });
}

/// Returns whether two mirrors meet at a right angle with the domain between them: light that they both
/// reflect goes on as if there were no edge.
bool is_corner_of_mirrors(const ShadowEdge& edge) {
  if (edge.surfaces.size() != 2) return false;
  const ShadowEdge::Surface &one = edge.surfaces[0], &other = edge.surfaces[1];
  return one.mirrors && other.mirrors && one.normal.dot(other.away) < -1 + right_angle;
}

std::vector<Vec3> corners_of(std::span<const EmitterPart> flat) {
  std::vector<Vec3> corners;
  Eigen::AlignedBox3d box;
  for (const EmitterPart& part : flat)
    for (const Vec3& corner : triangle_of(part)) {
      box.extend(corner);
      if (std::ranges::find(corners, corner) == corners.end()) corners.push_back(corner);
    }
  if (corners.size() <= most_corners) return corners;
  corners.clear();
  for (int i = 0; i < 8; ++i) corners.push_back(box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)));
  return corners;
}

bool are_parted(const Vec3& axis, const Vec3& begin, const Vec3& end, std::span<const Vec3> hull,
                double distance) {
  const double length = axis.norm();
  if (!(length > 0)) return false;
  const auto [low, high] = std::minmax({axis.dot(begin), axis.dot(end)});
  double least = axis.dot(hull[0]), most = least;
  for (const Vec3& point : hull.subspan(1)) {
    const double at = axis.dot(point);
    least = std::min(least, at);
    most = std::max(most, at);
  }
  return high <= least + distance * length || low >= most - distance * length;
}

}  // namespace

bool reaches_into(const Vec3& begin, const Vec3& end, std::span<const Vec3> hull, double distance) {
  for (std::size_t i = 0; i < hull.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Vec3 way = hull[j] - hull[i];
      if (are_parted(way.cross(end - begin), begin, end, hull, distance)) return false;
      for (std::size_t k = 0; k < j; ++k)
        if (are_parted(way.cross(hull[k] - hull[i]), begin, end, hull, distance)) return false;
    }
  return true;
}

OccludingEdges::OccludingEdges(const LightPaths& paths, const ExtendedSource& source,
                               const std::vector<ShadowEdge>& shadow_edges)
    : planes_(paths.mirrors()), light_(corners_of(source.flat_parts())) {
  if (light_.empty()) return;
  std::ranges::copy_if(shadow_edges, std::back_inserter(shadow_edges_), [](const ShadowEdge& edge) {
    return is_of_walls(edge) && !is_corner_of_mirrors(edge);
  });
  std::size_t count = 0;
  for (const MirrorSet mirrors : planes_.images_of_point()) {
    images_.push_back({mirrors, {}});
    for (const MirrorCopy& copy : copies_behind(planes_, mirrors))
      for (std::size_t i = 0; i < shadow_edges_.size() && ++count <= most_occluding_edges; ++i) {
        Copy edge{i, copy.point(shadow_edges_[i].begin), copy.point(shadow_edges_[i].end), {}};
        edge.box.extend(edge.begin).extend(edge.end);
        images_.back().edges.push_back(edge);
      }
  }
  if (count > most_occluding_edges) images_.clear();
}

std::vector<ShadowEdge> OccludingEdges::before(std::span<const Vec3> corners) const {
  std::vector<char> stands_before(shadow_edges_.size(), 0);
  std::vector<Vec3> hull = light_;
  for (const Image& image : images_) {
    hull.resize(light_.size());
    for (const Vec3& corner : corners) hull.push_back(planes_.image(image.mirrors, corner));
    Eigen::AlignedBox3d box;
    for (const Vec3& point : hull) box.extend(point);
    const double distance = touching * box.diagonal().norm();
    for (const Copy& edge : image.edges)
      if (stands_before[edge.number] == 0 && box.intersects(edge.box) &&
          reaches_into(edge.begin, edge.end, hull, distance))
        stands_before[edge.number] = 1;
  }
  std::vector<ShadowEdge> edges;
  for (std::size_t i = 0; i < shadow_edges_.size(); ++i)
    if (stands_before[i] != 0) edges.push_back(shadow_edges_[i]);
  return edges;
}

}  // namespace etendue
