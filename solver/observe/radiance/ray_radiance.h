// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "solver/observe/radiance/collided_source.h"
#include "solver/observe/radiance/glossy_rays.h"
#include "solver/observe/radiance/once_scattered.h"
#include "solver/observe/radiance/ray_entry.h"
#include "solver/observe/radiance/wall_light.h"

namespace etendue {

/// How many rays a point of a wall sends to each light with an extent where nothing else is said.
inline constexpr int fine_shadow_rays = 128;
/// And where many rays meet walls, so that the steps of each penumbra are lost among them.
inline constexpr int quick_shadow_rays = 16;

/// How a ray looks.
struct RayView {
  int shafts = 0;                           ///< as in Camera
  const WallIrradiance* brought = nullptr;  ///< what directions brought to the walls; null: as joined
  bool first_wall_diffuse = true;      ///< else the wall that the ray meets first reflects as a mirror alone
  int glossy = default_glossy_rays;    ///< as in Camera
  bool lights_shown = true;            ///< else only what is scattered and reflected, and other emission
  int shadow_rays = fine_shadow_rays;  ///< as in WallLight::add_light()
};

/// The radiance that comes to a point along a ray, from a saved solution:
///
///     L = integral of e^(-tau) (q + S) ds + e^(-tau) L_wall                                          (1)
///
/// with S of CollidedSource and OnceScattered, linear in each cell, so that (1) is closed there. Walls send
/// what they emit and that of WallLight; at mirrors the ray continues, and at glossy walls it parts into rays
/// that are drawn from f_r, which take a glossy wall that they meet for a diffuse one of the same mean
/// albedo. Lights are seen where they have an extent. What is seen of them, and what they are said to have
/// scattered, goes through the whole extinction; the rest through that of CollidedSource.
class RayRadiance {
 public:
  /// `options` are those of the solution (elements, meters). The arguments must outlive it. Without first
  /// collisions the lights are followed anew. Throws InputError where the state is not of this kind.
  RayRadiance(const LightSetup& lights, const DirectionSet& directions, const SolveOptions& options,
              const SavedState& state, int threads, WallValues walls = WallValues::joined,
              std::shared_ptr<const FirstCollisions> first = nullptr);

  /// What one thread works with.
  struct Workspace {
    explicit Workspace(const RayRadiance& radiance);

    struct Part {
      CellIndex cell;
      double from;
      double length;
    };
    LightBeams beams;
    OnceScattered::Memory memory;
    std::vector<Part> parts;
    std::vector<double> values;      ///< as CollidedSource has them
    std::vector<double> depth;       ///< [band] optical, whole
    std::vector<double> depth_rest;  ///< [band] that the rest sees
    std::vector<double> factor;      ///< [band] of mirrors
    std::vector<double> at_point;    ///< [band]
    std::optional<CollidedSource::View> view;
    std::unique_ptr<Workspace> inner;  ///< of rays that leave a glossy wall
    /// [wall][band] radiance by formulas of place and direction, where there are any; a thread has its own
    std::vector<std::vector<std::optional<AngularFormula>>> wall_formulas;
  };

  std::size_t bands() const { return bands_; }
  /// For other solutions of the same problem.
  const std::shared_ptr<const FirstCollisions>& first_collisions() const { return once_.first(); }

  /// A point of a cell where the ray starts, or where it comes in through the back of a wall; empty where it
  /// meets nothing.
  std::optional<PointInCell> enter(const Vec3& origin, const Vec3& direction) const {
    return entry_.enter(origin, direction);
  }

  /// Writes the radiance [band] that arrives at `start` from where the unit vector `direction` points.
  void along(const PointInCell& start, const Vec3& direction, const RayView& view, Workspace& work,
             std::span<double> radiance) const;

  /// The distance to the wall that `direction` points to, and the radiance [band] that it reflects diffusely
  /// at that point, where the lights bring it `irradiance` [band]. Mirrors are not followed.
  struct DiffuseWall {
    double distance;
    std::vector<double> radiance;
  };
  DiffuseWall diffuse_wall(const PointInCell& start, const Vec3& direction,
                           std::span<const double> irradiance, Workspace& work) const;

  const Problem& problem() const { return problem_; }

 private:
  struct RaySegment;
  struct FirstReflection;
  RayEnd walk(const PointInCell& from, const Vec3& direction, Workspace& work) const;
  void add_cells(const RaySegment& segment, Workspace& work, std::span<double> radiance) const;
  void add_part(const RaySegment& segment, const Workspace::Part& part, Workspace& work,
                std::span<double> radiance) const;
  void add_shafts(const RaySegment& segment, const Workspace::Part& part, Workspace& work,
                  std::span<double> radiance) const;
  void add_flat_lights(const RaySegment& segment, double length, Workspace& work,
                       std::span<double> radiance) const;
  void add_wall(FaceIndex face, const Vec3& point, const RaySegment& segment, Workspace& work,
                std::span<double> radiance) const;
  void add_skies(FaceIndex face, const RaySegment& segment, const Workspace& work,
                 std::span<double> radiance) const;
  void add_glossy(FaceIndex face, const Vec3& point, const RaySegment& segment, Workspace& work,
                  std::span<double> radiance) const;
  void add_glossy_lights(FaceIndex face, const Vec3& point, const RaySegment& segment, Workspace& work,
                         std::span<double> sum) const;
  void add_glossy_rays(FaceIndex face, const Vec3& point, const RaySegment& segment, Workspace& work,
                       std::span<double> sum) const;
  bool reflect(FaceIndex face, double cosine, Workspace& work) const;
  std::vector<double> weights_left(const Workspace& work) const;
  /// Returns whether the rounds of a ray that is back at its first mirror could be added up.
  bool end_series(const FirstReflection& first, const Workspace& work, std::span<double> radiance) const;
  void find_dark_cells();

  const LightSetup& lights_;
  const Problem& problem_;
  std::size_t bands_;
  CollidedSource collided_;
  OnceScattered once_;
  WallLight walls_;
  RayEntry entry_;
  std::vector<char> is_void_;  ///< [cell] neither takes nor gives light
};

}  // namespace etendue
