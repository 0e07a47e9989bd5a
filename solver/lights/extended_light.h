// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/lights/cell_light.h"
#include "solver/lights/collapsed_rule.h"
#include "solver/lights/wide_source.h"

namespace etendue {

/// What light with an extent meets on its way to a place. Extinction and turn vary slowly, where fluence does
/// not.
struct WayLoss {
  double visible = 1;        ///< part of the fluence that nothing opaque stands before
  double extinction = 0;     ///< of the even matter that takes as much of the visible part [1/length]
  Vec3 turn = Vec3::Zero();  ///< by how much the mean direction, net flux over fluence, differs from there
  double way = 0;            ///< mean length of the visible part [length]
};

/// Light of a source with an extent in cells and on walls. What would arrive through matter that is the same
/// everywhere needs no rays: it is integrated as finely as it varies. Which extinction that matter has to
/// have for as much to arrive as through the media that there are, and what obstacles leave, is looked at
/// from the vertices of the mesh, shared by the cells around them, and taken linear in a cell; near a surface
/// that shines from points of the cell itself; and in shadows, and in matter at the edge of a cloud, from
/// each point that is asked. In an even medium nothing is left to be interpolated.
class ExtendedLight {
 public:
  ExtendedLight(const LightPaths& paths, const WideSource& source, int threads);

  void add(const LitCell& cell, LightBeams& beams, NodalMoments& moments) const;
  void add(FaceIndex face, LightBeams& beams, NodalMoments& moments) const;

 private:
  /// What a place sees of the light: all, a part, nothing; it lies behind; or that depends on the side of a
  /// sheet.
  enum class Seen : char { all, part, nothing, behind, by_side };
  template <std::size_t corners>
  struct Site;
  struct Arrived;

  Seen look(const PointInCell& here, LightDetail detail, LightBeams& beams, std::span<WayLoss> loss) const;
  void arrive(const Vec3& place, std::span<const WayLoss> loss, LightBeams& beams, Arrived& light) const;
  /// Losses are [corner][band]. False where a corner does not see all.
  template <std::size_t corners>
  bool take_from_vertices(std::span<const std::int32_t> vertices,
                          std::array<std::vector<WayLoss>, corners>& losses) const;
  /// Whether losses vary so little between the corners that they are linear in between.
  template <std::size_t corners>
  bool is_even(const std::array<std::vector<WayLoss>, corners>& losses) const;
  /// False where a point is in the shadow.
  template <std::size_t corners>
  bool look_inside(const Site<corners>& site, LightBeams& beams,
                   std::array<std::vector<WayLoss>, corners>& losses) const;
  /// Of a part of a cell or a face.
  template <std::size_t corners>
  SteepCorners<corners> steep_corners(const Site<corners>& site,
                                      const std::array<std::array<double, corners>, corners>& part) const;
  template <std::size_t corners, class Deposit>
  void add_lit(const Site<corners>& site, const std::array<std::vector<WayLoss>, corners>& losses,
               int divisions, const Deposit& deposit, LightBeams& beams, NodalMoments& moments) const;
  template <std::size_t corners, class Deposit>
  void add_point_by_point(const Site<corners>& site,
                          const std::array<std::array<double, corners>, corners>& part, double measure,
                          int divisions, const Deposit& deposit, LightBeams& beams,
                          NodalMoments& moments) const;
  template <std::size_t corners, class Deposit>
  void add(const Site<corners>& site, std::span<const std::int32_t> vertices, int divisions,
           const Deposit& deposit, LightBeams& beams, NodalMoments& moments) const;

  const LightPaths& paths_;
  const WideSource& source_;
  std::size_t bands_;
  std::vector<WayLoss> losses_;  ///< [vertex][band]
  std::vector<Seen> seen_;       ///< [vertex]
};

}  // namespace etendue
