// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "solver/uncollided/closed_form/solid_angle.h"
#include "solver/uncollided/rays/light_beams.h"
#include "solver/uncollided/rays/light_paths.h"

namespace etendue {

/// Whether media and obstacles are seen.
enum class Sight { attenuated, clear };

struct ShadowEdge;

/// Subdivision of a light that is not a point: parts are taken for four or eight points each where
/// their radius is below `opening` times their distance and their own optical thickness below `thickness`,
/// and for one below `single`; nearer ones are integrated over their solid angle by a rule on triangles with
/// sides of `largest_side`. With shadow edges each triangle that shines is cut along those that stand before
/// it, so that each part is seen wholly or not at all.
struct LightDetail {
  double opening;
  double single;
  double thickness;
  double largest_side;
  TriangleRule rule;
  const std::vector<ShadowEdge>* shadow_edges = nullptr;
};
constexpr LightDetail coarse_light{0.7, 0.03, 0.6, 0.9, TriangleRule::three_points};
constexpr LightDetail fine_light{0.2, 0.01, 0.15, 0.25, TriangleRule::seven_points};

class BeamSource;
class PointSource;
class WideSource;

/// Something whose uncollided light is integrated along rays.
class LightSource {
 public:
  LightSource(std::string name, std::vector<double> power)
      : name_(std::move(name)), power_(std::move(power)) {}
  virtual ~LightSource() = default;

  const std::string& name() const { return name_; }
  const std::vector<double>& power() const { return power_; }  ///< [band] that it sends [power]

  /// Adds the beams that arrive at a point. Without attenuation the light comes as in empty space, from
  /// behind mirrors too: of a light with an extent what they reflect of it.
  virtual void add_beams(const PointInCell& at, Sight sight, LightDetail detail, LightBeams& beams) const = 0;
  /// The light as a point, if it is one.
  virtual const PointSource* as_point() const { return nullptr; }
  /// The light as a beam, if it is one.
  virtual const BeamSource* as_beam() const { return nullptr; }
  /// Returns whether it is near enough, or wide enough, for its parts to be sampled one by one from a place
  /// of this size: suns never are, beams with a cross-section of their own always.
  virtual bool is_near(const Vec3& place, double size) const = 0;
  /// The light as one that comes from many directions, if it is one.
  virtual const WideSource* as_wide() const { return nullptr; }

 private:
  std::string name_;
  std::vector<double> power_;
};

using LightSources = std::vector<std::unique_ptr<LightSource>>;

}  // namespace etendue
