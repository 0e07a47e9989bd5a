// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/angular/harmonics/harmonics.h"
#include "solver/angular/sets/direction_set.h"
#include "solver/exact/exact_radiance.h"
#include "solver/exact/quadratic_nodes.h"
#include "solver/problem/problem.h"
#include "solver/solution/angular_input.h"
#include "solver/transport/scattering/scattering_plan.h"

namespace etendue {

/// Source and inflow for which a given radiance u solves a problem at the ordinates of a set:
///
///     s_m = w_m.grad u_m + sigma_t u_m - sigma_s/(4 pi) sum over k of chi_l(k) Y_k(m) phi_k,
///     phi_k = sum over n of w_n Y_k(n) u_n,
///
/// with the set's own scattering kernel, that of ScatteringMoments or of DenseScattering: all that is left of
/// the error is that of the discretisation in space. At walls, which must be black, u enters. Both are
/// projected from their values at QuadraticNodes: values at the vertices alone would keep the order in L2,
/// but not that of means.
class ExactInput : public AngularInput {
 public:
  /// The arguments must outlive it. Throws InputError, naming the point, where the radiance or its gradient
  /// is not finite at a node.
  ExactInput(const Problem& problem, const DirectionSet& directions, const ExactRadiance& radiance);

  void add_source(OrdinateIndex m, CellIndex cell, std::span<double> values) const override;
  void add_inflow(OrdinateIndex m, FaceIndex face, std::span<double> values) const override;

  /// [region][band] power of the source, as the discretisation sees it; may be negative.
  std::vector<std::vector<double>> source_powers() const;

 private:
  std::size_t at(OrdinateIndex m, std::size_t node) const { return m.at() * nodes_.count() + node; }
  void fill_values(const ExactRadiance& radiance);
  void fill_moments();
  void fill_kernels();
  void fill_matrices();
  double scattered(OrdinateIndex m, std::size_t node, std::span<const double> kernel) const;

  const Problem& problem_;
  const DirectionSet& directions_;
  std::vector<ScatteringTreatment> plan_;  ///< [region * bands + band]
  QuadraticNodes nodes_;
  DiscreteHarmonics harmonics_;
  std::vector<double> radiance_;   ///< [ordinate][node] u
  std::vector<double> streaming_;  ///< [ordinate][node] w.grad u
  std::vector<double> moments_;    ///< [node][k] phi_k
  std::vector<double> kernels_;    ///< [region][band][k] chi_l(k)/(4 pi); 0 beyond the degree that is used
  /// Of a medium and band that scatters by a matrix.
  struct MatrixTerms {
    std::vector<double> leaving;    ///< [ordinate]
    std::vector<double> scattered;  ///< [ordinate][node] sum over n of K_mn w_n u_n
  };
  std::vector<MatrixTerms> matrices_;
  std::vector<int> matrix_of_;  ///< [region * bands + band], -1 without
};

}  // namespace etendue
