// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "solver/radiosity/exchange/exchange.h"
#include "solver/radiosity/extended/extended_paths.h"
#include "solver/radiosity/extended/sparse_rows.h"

namespace etendue {

/// What closing an ExtendedExchange took.
struct ExtendedClosing {
  double row_sum = 0, row_sum_mean = 0;  ///< largest and root mean square deviation from one, as found
  double closed_row_sum = 0;             ///< the largest when closed
  int passes = 0;
};

/// The exchange areas of patches for diffuse light, straight and via mirrors and glossy walls (extended
/// form factors, Sillion and Puech 1989): a symmetric matrix for each band,
///
///     G = D (G_0 + G_1) D,                                                                             (1)
///
/// G_0 between patches that see each other, and G_1 of rays that leave each patch evenly over its area and
/// as the cosine, and are followed over walls that redirect them. As both directions are sampled, G_1 is the
/// mean of what the rays of either patch find. Of the power incident on a patch, A_j H_j = sum over k of G_jk
/// B_k, the wall redirects the part
///
///     sum over k of (a_j G_jk + C_jk) B_k,                                                             (2)
///
/// a_j of isotropic light, and C of the angles at which the rays of both patches meet, zero where the
/// redirected part is the same at all: what is redirected lies between nothing and all that arrives. The
/// diagonal D makes what stays of the light of any patch all of it. That there is such a D is known where
/// C = 0 (Sinkhorn 1964).
class ExtendedExchange {
 public:
  /// `straight` must outlive it, and so must the others. `rays` leave each patch.
  ExtendedExchange(const Exchange& straight, const Problem& problem, const WallPatches& patches,
                   Redirection by, int rays);

  std::size_t size() const { return straight_.size(); }
  std::size_t bands() const { return paths_.bands(); }
  const ExtendedPaths& paths() const { return paths_; }
  std::size_t entries() const { return found_.entries(); }  ///< of G_1

  /// [patch][band] G x of x [patch][band].
  std::vector<double> times(std::span<const double> x) const;
  /// [patch][band] of G_jk.
  std::vector<double> row(std::size_t j) const;
  /// [patch][band] power that walls redirect of light x, of which times(x) arrives. After close().
  std::vector<double> redirected(std::span<const double> x, std::span<const double> arriving) const;

  /// Finds D, for straight exchange as it is now.
  ExtendedClosing close(double tolerance);
  /// Takes D from another one of the same patches.
  void close_as(const ExtendedExchange& other) { scale_ = other.scale_; }

 private:
  void weigh_straight_change();

  const Exchange& straight_;
  ExtendedPaths paths_;
  std::size_t stored_;             ///< bands that differ: all, or one for all
  SparseRows found_;               ///< G_1
  SparseRows change_;              ///< C of G_1
  SparseRows straight_share_;      ///< C of G_0, of what is exchanged
  SparseRows straight_change_;     ///< C of G_0, for straight exchange as it was when closed
  std::vector<double> redirects_;  ///< a [patch][band]
  std::vector<double> scale_;      ///< D [patch][band]
};

}  // namespace etendue
