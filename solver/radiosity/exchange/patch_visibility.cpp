// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/exchange/patch_visibility.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/random/even_points.h"
#include "solver/radiosity/patches/wall_patches.h"

namespace etendue {
namespace {

// Where some rays are blocked, so many times the rays are sent.
constexpr int rays_of_shadows = 8;
// The same from a point, whose light a single patch may bring: 64 rays err by a percent of it.
constexpr int rays_of_shadows_at_a_point = 16;
// Distance behind a plane, relative to the size of a patch and its distance, that is rounding.
constexpr double behind_plane = 1e-9;

/// Returns whether nothing of a node, or of the remaining part of it, lies behind a plane.
bool all_before(const PatchTree& tree, const PatchNode& node, const FlatPatch& plane) {
  const Vec3 separation = node.center - plane.centroid();
  const double height = plane.normal().dot(separation),
               close = behind_plane * (separation.norm() + node.radius + plane.radius());
  if (height > node.radius - close) return true;
  if (!node.is_patch()) {
    const auto child = static_cast<std::size_t>(node.children);
    return all_before(tree, tree.nodes()[child], plane) && all_before(tree, tree.nodes()[child + 1], plane);
  }
  const FlatPatch& patch = tree.patches()[static_cast<std::size_t>(tree.patches_of(node)[0])];
  for (const TriangleCorners& t : patch.triangles())
    for (const Vec3& corner : t)
      if (plane.normal().dot(corner - plane.centroid()) < -close) return false;
  return true;
}

/// Looks once into each plane that patches lie in, one after the other.
bool are_convex(const std::vector<FlatPatch>& patches) {
  const PatchTree tree(patches);
  const FlatPatch* last = nullptr;
  for (const std::int32_t p : tree.order()) {
    const FlatPatch& plane = patches[static_cast<std::size_t>(p)];
    const bool same = last != nullptr && last->normal() == plane.normal() && last->offset() == plane.offset();
    if (!same && !all_before(tree, tree.nodes()[0], plane)) return false;
    last = &plane;
  }
  return true;
}

struct Seen {
  double open = 0, all = 0;
  int blocked = 0, sent = 0;

  // Where no ray carries anything, hardly a corner of one is before the other.
  double share() const { return all > 0 ? open / all : 1; }
};

/// Sends rays between points: `draw` gives both ends.
template <class Draw>
Seen look(const RayScene& scene, int rays, const Draw& draw) {
  Seen seen;
  const auto send = [&](int count) {
    for (int i = 0; i < count; ++i) {
      const auto [from, to] = draw();
      const Vec3 separation = to.position - from.position;
      const double r2 = separation.squaredNorm();
      const double leaving = from.normal.dot(separation), arriving = -to.normal.dot(separation);
      if (!(leaving > 0 && arriving > 0)) continue;
      const double carried = leaving * arriving / (r2 * r2);
      ++seen.sent;
      seen.all += carried;
      if (scene.is_blocked(from.position, to.position))
        ++seen.blocked;
      else
        seen.open += carried;
    }
  };
  send(rays);
  if (seen.blocked > 0 && seen.blocked < seen.sent) send((rays_of_shadows - 1) * rays);
  return seen;
}

}  // namespace

PatchVisibility::PatchVisibility(const std::vector<FlatPatch>& patches, int rays, int threads)
    : patches_(patches), rays_(rays) {
  if (!are_convex(patches)) scene_ = std::make_unique<RayScene>(triangles_of(patches), threads);
}

double PatchVisibility::share(std::size_t a, std::size_t b) const {
  if (is_convex()) return 1;
  const std::size_t low = std::min(a, b), high = std::max(a, b);
  const FlatPatch &first = patches_[low], &second = patches_[high];
  EvenPoints<4> points(low * patches_.size() + high);
  return look(*scene_, rays_,
              [&] {
                const std::array<double, 4>& at = points.next();
                return std::pair{SurfaceSite{first.point_at(at[0], at[1]), first.normal()},
                                 SurfaceSite{second.point_at(at[2], at[3]), second.normal()}};
              })
      .share();
}

double PatchVisibility::share(const PatchTree& tree, std::size_t a, std::size_t b) const {
  if (is_convex()) return 1;
  const std::size_t low = std::min(a, b), high = std::max(a, b);
  EvenPoints<6> points(low * tree.nodes().size() + high);
  return look(*scene_, rays_,
              [&] {
                const std::array<double, 6>& at = points.next();
                return std::pair{tree.site_of(tree.nodes()[low], at[0], at[1], at[2]),
                                 tree.site_of(tree.nodes()[high], at[3], at[4], at[5])};
              })
      .share();
}

double PatchVisibility::share_from(const Vec3& point, std::size_t patch, int rays) const {
  if (is_convex()) return 1;
  const FlatPatch& seen = patches_[patch];
  if (rays == 1) return scene_->is_blocked(point, seen.centroid()) ? 0 : 1;
  EvenPoints<4> points(patch);
  double open = 0, all = 0;
  for (int i = 0; i < rays || (i < rays_of_shadows_at_a_point * rays && open > 0 && open < all); ++i) {
    const std::array<double, 4>& at = points.next();
    const Vec3 to = seen.point_at(at[0], at[1]), separation = to - point;
    const double carried = -seen.normal().dot(separation) / (separation.squaredNorm() * separation.norm());
    if (!(carried > 0)) continue;
    all += carried;
    if (!scene_->is_blocked(point, to)) open += carried;
  }
  return all > 0 ? open / all : 1;
}

}  // namespace etendue
