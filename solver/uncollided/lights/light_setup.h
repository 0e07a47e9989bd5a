// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "solver/problem/problem.h"
#include "solver/uncollided/projection/uncollided_field.h"
#include "solver/uncollided/rays/shadow_edges.h"

namespace etendue {

/// Light at a point, per band, computed there and not interpolated.
struct LightAtPoint {
  std::vector<double> fluence;     ///< [band] [power/length^2]
  std::vector<Vec3> net_flux;      ///< [band]
  std::vector<double> irradiance;  ///< [band] on the side that a normal points to; empty without one
};

/// Which emissions of a problem are lights, so that their uncollided part is integrated along rays: all that
/// it calls lights and that do not say no, and the media and walls that say so, or that say nothing and are
/// small (below 5 % of the volume, or of the boundary). Light along rays ends at walls that refract.
class LightSetup {
 public:
  /// The problem must outlive it; `added` is as of LightPaths. Throws InputError where a mirror does not
  /// allow what is asked.
  explicit LightSetup(const Problem& problem, std::vector<double> added = {});

  bool empty() const { return sources_.empty(); }
  const Problem& problem() const { return problem_; }
  const LightPaths& paths() const { return paths_; }
  const LightSources& sources() const { return sources_; }
  /// The kind of a source, and its number among those of its kind in the problem; of the beams of a sky the
  /// first.
  struct Emitter {
    enum class Kind { light, region, wall } kind;
    std::size_t number;
  };
  const std::vector<Emitter>& emitters() const { return emitters_; }  ///< [source]
  bool has_wall(int wall) const { return wall_is_light_[static_cast<std::size_t>(wall)] != 0; }
  bool has_region(int region) const { return region_is_light_[static_cast<std::size_t>(region)] != 0; }
  /// The problem without what these lights emit; lights that are left to the directions are in it.
  Problem remaining() const;
  /// What became a light and why, a line each.
  const std::vector<std::string>& notes() const { return notes_; }

  /// Of the problem, behind which its lights are seen in part.
  const std::vector<ShadowEdge>& shadow_edges() const { return shadow_edges_; }
  /// Uncollided light at a point of a cell, at the finer detail and cut along shadow edges.
  LightAtPoint at(const PointInCell& point, const std::optional<Vec3>& normal) const;

 private:
  void refuse_all(const std::string& where, const std::string& instead);
  void add_lights();
  void add_regions();
  void add_walls();
  /// Refuses lights that reach a wall that refracts from within with more than a trifle of their power.
  void check_refraction();
  bool chosen(Uncollided asked, double part, const std::string& what);

  const Problem& problem_;
  LightPaths paths_;
  std::vector<ShadowEdge> shadow_edges_;
  LightSources sources_;
  std::vector<Origin> origins_;  ///< [source]
  std::vector<Emitter> emitters_;
  std::vector<char> region_is_light_;
  std::vector<char> wall_is_light_;
  bool refracting_ = false;  ///< some wall does
  std::vector<std::string> notes_;
};

}  // namespace etendue
