// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <atomic>
#include <string>

#include "base/parallel/copy_pool.h"
#include "solver/photons/sampling/direction_sampler.h"
#include "solver/photons/sampling/kernel_bound.h"
#include "solver/problem/problem.h"

namespace etendue {

/// Draws where a kernel by a formula scatters light, by rejection against its bound.
///
/// Of a formula that is a product of a factor of the place and one of the directions it draws until a
/// direction is kept: the scattering coefficient is known. Any other is another kernel in each cell, at its
/// centroid. Light then meets something as often as the bound says, and is scattered as often as a first draw
/// is kept; else it has met nothing and continues (Woodcock et al. 1965; Coleman 1968): that scatters at the
/// rate of the kernel's own integral, which nobody needs to know.
class KernelSampler : public DirectionSampler {
 public:
  /// The mesh must outlive it.
  KernelSampler(const KernelFormula& kernel, const TetrahedralMesh& mesh, int region);

  Vec3 scattered(CellIndex cell, const Vec3& travel, DrawnNumbers& random) const override;
  double meeting_rate() const override { return of_product_ ? 0 : bound_.total(); }
  /// Draws where the kernel was larger than its bound, and all.
  std::pair<std::int64_t, std::int64_t> beyond_bound() const { return {beyond_, draws_}; }

 private:
  /// Copies have a parser of their own.
  struct OwnKernel {
    explicit OwnKernel(const KernelFormula& kernel);
    OwnKernel(const OwnKernel& other) : OwnKernel(other.formula) {}
    KernelFormula formula;
  };

  const TetrahedralMesh& mesh_;
  bool of_product_;
  KernelBound bound_;
  mutable CopyPool<OwnKernel> pool_;
  mutable std::atomic<std::int64_t> beyond_ = 0, draws_ = 0;
};

}  // namespace etendue
