// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/angular/sets/direction_set.h"
#include "solver/problem/phase_list.h"
#include "solver/solution/angular_input.h"
#include "solver/uncollided/first_collision/glossy_reflection.h"
#include "solver/uncollided/lights/light_setup.h"

namespace etendue {

/// First-collision source of uncollided light: in the direction m the L2 projection on the linear functions
/// of a cell of
///
///     s_m(x) = sigma_s(x) integral over w' of u_0(x, w') P_m(w') dw',
///     P_m(w') = p(w_m.w') exp(h_m (a + b.w_m)),
///
/// with the exact phase function p, corrected near its peak so that the scattered power is sigma_s phi_0 and
/// the net flux g sigma_s F_0 (conserve_moments); in media whose coefficients depend on the direction the
/// kernel k(w' -> w_m) replaces p. The integral runs over the directions w' of CollisionField,
/// which the light of each cell has. At walls, the radiance that is diffusely reflected, (diffuse / pi_h) E,
/// transmitted from the other side of a sheet, (transmittance / pi_h) E(behind), and reflected by f_r
/// (GlossyReflection).
class FirstCollision : public AngularInput {
 public:
  /// The arguments must outlive it. Values of the field may change between sweeps, but not the directions
  /// that its collisions have.
  FirstCollision(const Problem& problem, const RayMatter& matter, const UncollidedField& field,
                 const DirectionSet& directions, int threads);
  FirstCollision(const LightSetup& lights, const UncollidedField& field, const DirectionSet& directions,
                 int threads)
      : FirstCollision(lights.problem(), lights.paths().matter(), field, directions, threads) {}

  bool depends_on_direction(CellIndex cell) const override;
  void add_source(OrdinateIndex, CellIndex, std::span<double>) const override {}
  void add_projected_source(OrdinateIndex m, CellIndex cell, std::span<double> values) const override;
  void add_inflow(OrdinateIndex m, FaceIndex face, std::span<double> values) const override;

  /// Upper estimate of the bytes that one will take, the uncollided field included.
  static std::size_t memory(const LightSetup& lights, const DirectionSet& directions);

 private:
  /// Finds which directions light comes from where a medium scatters by each of the tables.
  std::vector<std::vector<Vec3>> number_directions();
  void tabulate_phase(const PhaseFunction& phase, std::span<const Vec3> directions, int threads,
                      std::vector<double>& table) const;
  /// Which of the tables a region and band have; -1 where scattering is isotropic.
  int table_of(int region, std::size_t band) const;
  double scattered(CellIndex cell, std::size_t node, std::size_t band) const;

  const Problem& problem_;
  const UncollidedField& field_;
  const DirectionSet& directions_;
  PhaseList phases_;
  const RayMatter& matter_;
  /// Of phase functions, then of kinds of medium: P_m(w') - 1/(4 pi) [1/sr], [ordinate][direction]
  std::vector<std::vector<double>> tables_;
  std::vector<std::vector<std::int32_t>> number_;  ///< [table][incident direction] its place, -1: not there
  std::vector<std::size_t> length_;                ///< [table] number of directions
  std::vector<double> half_range_;                 ///< [boundary face] [sr]
  std::vector<std::int32_t> behind_;               ///< [boundary face] other side of a sheet, -1: none
  GlossyReflection glossy_;
};

}  // namespace etendue
