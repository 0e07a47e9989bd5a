// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/angle/direction_set.h"
#include "solver/lights/light_setup.h"
#include "solver/ordinates/angular_input.h"
#include "solver/problem/phase_list.h"
#include "solver/split/glossy_reflection.h"

namespace etendue {

/// What uncollided light becomes for the sweep: where it scatters first, a source in the direction m of
///
///     s_m = sigma_s phi p(w_m.w') / sum over n of w_n p(w_n.w'),
///
/// with the exact phase function p, divided by its sum over the set so that the scattered power is sigma_s
/// phi, and tilted so that its net flux is that of p; where matter depends on the directions themselves, with
/// its kernel k(w' -> w_m) in place of p and the integral of sigma_s(w') over the light; and at walls the
/// radiance that is diffusely reflected, (diffuse / pi_h) E, transmitted from the other side of a sheet,
/// (transmittance / pi_h) E(behind), and reflected by f_r (GlossyReflection).
///
/// The direction w' of the light enters by its distribution at the vertices; phi is the P1 projection.
class FirstCollision : public AngularInput {
 public:
  /// The arguments must outlive it.
  FirstCollision(const LightSetup& lights, const UncollidedField& field, const DirectionSet& directions,
                 int threads);

  bool depends_on_direction(CellIndex cell) const override;
  void add_source(OrdinateIndex m, CellIndex cell, std::span<double> values) const override;
  void add_inflow(OrdinateIndex m, FaceIndex face, std::span<double> values) const override;

  /// Upper estimate of the bytes that one will take, the uncollided field included.
  static std::size_t memory(const LightSetup& lights, const DirectionSet& directions);

 private:
  void tabulate(const LightSetup& lights, int threads);
  void tabulate_phase(const LightSource& source, const PhaseFunction& phase, int threads,
                      std::vector<double>& table) const;
  /// Which of a source's tables a region and band have; -1 where all directions are alike.
  int table_of(int region, std::size_t band) const;

  const Problem& problem_;
  const UncollidedField& field_;
  const DirectionSet& directions_;
  PhaseList phases_;
  const RayMatter& matter_;
  /// [source * tables + table] [ordinate][vertex] [1/sr]: of phase functions, then of kinds of matter
  std::vector<std::vector<double>> scattered_;
  std::vector<double> half_range_;    ///< [boundary face] [sr]
  std::vector<std::int32_t> behind_;  ///< [boundary face] other side of a sheet, -1: none
  GlossyReflection glossy_;
};

}  // namespace etendue
