// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "solver/angular/sets/direction_set.h"
#include "solver/problem/problem.h"
#include "solver/transport/order/ordinate_schedule.h"
#include "solver/transport/order/sweep_slots.h"
#include "solver/transport/state/transport_state.h"
#include "solver/transport/walls/glossy_walls.h"
#include "solver/transport/walls/wall_mirrors.h"

namespace etendue {

/// Walls at which a sweep accumulates the irradiance: those that reflect or whose emission follows from it,
/// or all.
enum class AccumulateAt { reflecting, all };

/// Exchange of light between the walls and the ordinates, equation (13) of docs/theory/theory.md:
///
///     u_in = radiance + (following radiance) + (diffuse / pi_h) E + (transmittance / pi_h) E(behind) +
///     specular u_out(mirrored)
///            + f_r by a matrix (GlossyWalls),    pi_h = sum of w |w.n| over w.n < 0,
///
/// with the discrete half range pi_h in place of pi, so that a wall gives back exactly what it reflects.
/// A refracting wall has Fresnel's reflectance r of the ordinate, equation (13a), in place of `specular`, and
/// its radiance is multiplied by n^2 (1 - r). Walls across z that no direction of the plane reaches take no
/// part.
class WallExchange {
 public:
  /// Throws InputError where a mirror's partner ordinate is not in the set. The arguments must outlive it.
  WallExchange(const Problem& problem, const DirectionSet& directions, const OrdinateSchedule& schedule,
               const WallSlots& wall_slots, int stride, int face_nodes);

  std::size_t irradiance_size() const;
  /// Of what the mirrors reflect in the next sweep, and of what they reflect within the same.
  std::size_t mirror_size() const { return glossy_.size() + mirrors_.size(WallMirrors::Pass::next_sweep); }
  std::size_t passing_size() const { return mirrors_.size(WallMirrors::Pass::this_sweep); }
  /// Returns whether the next sweep reflects light that arrives at a wall.
  bool feeds_back() const { return feeds_back_; }
  /// Part of the irradiance of a face that the next sweep reflects to this side.
  double fed_back(FaceIndex face, std::size_t band) const;
  /// [boundary face] [sr]
  const std::vector<double>& half_range() const { return half_range_; }
  /// [boundary face] what a radiance of 1 of its wall sends in [sr]: the half range but where it refracts
  std::vector<double> emission_range() const;
  const GlossyWalls& glossy() const { return glossy_; }
  /// Boundary faces whose walls reflect or transmit in some band, or emit what follows from the irradiance.
  bool reflects(FaceIndex face) const {
    return walls_.reflects[static_cast<std::size_t>(problem_.mesh().wall(face))] != 0;
  }

  /// Radiance that enters along every direction, from the last state: that of the walls and the light that
  /// they reflect or transmit diffusely, [boundary face][face node][stride]. What is glossy is reflected too,
  /// and kept.
  void form_inflow(const TransportState& last, Emission emission, int threads, std::span<double> inflow);
  /// Writes all inflow slots. They keep their values until they are written again.
  template <class Real>
  void fill(std::span<const double> inflow, const SweepSlotsOf<Real>& slots) const;
  /// Writes the inflow slots of mirrors and glossy walls along ordinate m: `inflow` and what they reflect of
  /// the last state or, where the schedule allows it, of this sweep (`passing`).
  template <class Real>
  void reflect(OrdinateIndex m, const TransportState& last, std::span<const double> passing,
               std::span<const double> inflow, const SweepSlotsOf<Real>& slots) const;
  /// Adds what the inflow slots send along ordinate m to `exitance` [boundary face][face node][stride].
  template <class Real>
  void add_exitance(OrdinateIndex m, const SweepSlotsOf<Real>& slots, std::span<double> exitance) const;

  /// Adds the radiance that leaves the cells at the walls along ordinate m to `irradiance`, and writes the
  /// mirrors' part of `next`, or `passing`. The irradiance of black walls matters for the results alone.
  template <class Real>
  void accumulate_irradiance(OrdinateIndex m, const SweepSlotsOf<Real>& slots, AccumulateAt what,
                             std::span<double> irradiance, std::span<double> mirrors,
                             std::span<double> passing) const;

  /// Adds radiance that brings the irradiance `after` - `before` to one face, the same in all directions, to
  /// the outgoing radiance of the ordinates there, in one band. Does nothing where the face is neither glossy
  /// nor a mirror of the next sweep.
  void add_leaving(FaceIndex face, std::size_t band, std::span<const double> before,
                   std::span<const double> after, std::span<double> mirrors) const;

 private:
  /// Boundary face.
  struct Face {
    Vec3 area_normal;      ///< out of the domain [length^2]
    double by_area;        ///< 1 / area
    double by_half_range;  ///< 1 / half range; 0 where no ordinate passes
    std::size_t wall;
  };

  /// Coefficients of the walls.
  struct Coefficients {
    Coefficients(std::span<const Wall> walls, std::size_t stride);

    std::vector<double> radiance;     ///< [wall][stride], times the square of the refractive index
    std::vector<double> diffuse;      ///< [wall][stride]
    std::vector<double> specular;     ///< [wall][stride]
    std::vector<double> transmitted;  ///< [wall][stride]
    std::vector<char> reflects;       ///< [wall] or its emission follows
  };

  /// All boundary faces. The lists are in an order that helps branch prediction: faces through which light
  /// leaves in the same directions are neighbors.
  struct BoundaryFaces {
    std::vector<Face> geometry;            ///< [boundary face]
    std::vector<std::int32_t> all;         ///< list
    std::vector<std::int32_t> reflecting;  ///< list
  };

  void list_faces();
  /// Adds the radiance of walls whose emission follows.
  void add_following(std::span<double> inflow) const;
  /// Of linear elements with as many bands as `LinearBands` says, or 0 for any.
  template <std::size_t LinearBands, class Real>
  void add_irradiance(OrdinateIndex m, const SweepSlotsOf<Real>& slots, std::span<const std::int32_t> faces,
                      std::span<double> irradiance) const;

  const Problem& problem_;
  const DirectionSet& directions_;
  const WallSlots& wall_slots_;
  std::size_t stride_;
  std::size_t face_length_;         ///< face nodes times stride
  std::vector<double> half_range_;  ///< [boundary face]
  Coefficients walls_;
  std::vector<std::int32_t>
      behind_;  ///< [boundary face] other side of a sheet, -1: none; empty: no wall transmits
  GlossyWalls glossy_;
  WallMirrors mirrors_;
  BoundaryFaces faces_;
  bool feeds_back_ = false;
};

}  // namespace etendue
