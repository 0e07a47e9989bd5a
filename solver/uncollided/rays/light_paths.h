// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mesh/tetrahedra/search/ray_mesh.h"
#include "solver/angular/media/ray_matter.h"
#include "solver/problem/problem.h"
#include "solver/uncollided/rays/medium_surfaces.h"
#include "solver/uncollided/rays/mirror_images.h"

namespace etendue {

/// A point of a cell, on its surface too.
struct PointInCell {
  CellIndex cell;
  Vec3 position;
};

/// Where a path back to the light left the domain.
struct WayOut {
  FaceIndex face;
  Vec3 direction;  ///< of the ray there
  Vec3 point;
};

/// Paths of uncollided light, followed from the point that it reaches back to the light. May be used by
/// several threads at a time.
class LightPaths {
 public:
  /// The problem must outlive it. `added` is extinction beside its own [cell][band] [1/length]; empty: none.
  explicit LightPaths(const Problem& problem, std::vector<double> added = {});

  const Problem& problem() const { return problem_; }
  const MirrorPlanes& mirrors() const { return mirrors_; }
  const RayMesh& rays() const { return rays_; }
  std::size_t bands() const { return bands_; }
  /// What depends on the direction.
  const RayMatter& matter() const { return matter_; }
  /// In the mean over directions [1/length].
  double extinction(CellIndex cell, std::size_t band) const { return extinction_[cell.at() * bands_ + band]; }
  double largest_extinction(CellIndex cell) const;
  /// Extinction for light that travels along a view of matter() [1/length].
  double extinction(CellIndex cell, std::size_t band, const RayMatter::View& light) const {
    return matter_.empty() ? extinction(cell, band)
                           : matter_.at(cell, band, light).extinction() + added(cell, band);
  }

  /// Transmittance [band] of the path from a point along a unit direction of this length, reflected by
  /// exactly these mirrors, their reflectances included. False where something opaque stands before its end;
  /// a wall at its end does not, to 1e-9 of the length or of the size of the domain.
  bool transmit(const PointInCell& from, const Vec3& direction, double length, MirrorSet mirrors,
                std::span<double> transmittance) const;

  /// The same until the ray leaves the domain by a wall that does not mirror; empty where it never does.
  std::optional<WayOut> leave(const PointInCell& from, const Vec3& direction,
                              std::span<double> transmittance) const;

 private:
  double added(CellIndex cell, std::size_t band) const {
    return added_.empty() ? 0 : added_[cell.at() * bands_ + band];
  }
  /// Of light that comes along a ray.
  RayMatter::View view_along(const Vec3& ray) const {
    return matter_.empty() ? RayMatter::View{} : matter_.view(-ray);
  }
  /// Adds the optical depth [band] of a path from cell to cell.
  RayEnd walk(const PointInCell& from, const Vec3& direction, double length, std::span<double> depth) const;
  /// The same as long as `enter` holds.
  template <class Condition>
  RayMesh::PartOfPath walk_while(const PointInCell& from, const Vec3& direction, double length,
                                 std::span<double> depth, const RayMatter::View& light,
                                 const Condition& enter) const;
  /// Where a path has come to.
  struct Place : PointInCell {
    bool exact = true;  ///< else the cell is another one of the same medium
  };
  struct Segment {
    double distance;
    std::optional<FaceIndex> wall = {};  ///< that ends it
    Place end;                           ///< only where a wall does
  };
  /// The same as walk() from surface to surface where extinction is constant; empty where it would need a
  /// cell that it does not know.
  std::optional<Segment> cross(const Place& from, const Vec3& direction, double length,
                               std::span<double> depth) const;
  enum class Steps { surfaces, cells };
  /// transmit(), in steps of one kind.
  std::optional<bool> follow(const PointInCell& from, const Vec3& direction, double length, MirrorSet mirrors,
                             Steps steps, std::span<double> transmittance) const;
  void reflect(FaceIndex face, std::span<double> factor) const;

  const Problem& problem_;
  std::size_t bands_;
  RayMesh rays_;
  MirrorPlanes mirrors_;
  RayMatter matter_;
  std::vector<double> added_;       ///< [cell][band] [1/length]; empty: none
  std::vector<double> extinction_;  ///< [cell][band] with what is added [1/length]
  MediumSurfaces surfaces_;
};

}  // namespace etendue
