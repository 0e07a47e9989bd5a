// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "solver/angular/media/ray_matter.h"
#include "solver/photons/sampling/kernel_sampler.h"
#include "solver/problem/problem.h"

namespace etendue {

/// What a region does in one band to photons whose absorption or scattering depends on their direction.
class DirectionalMedium {
 public:
  /// The problem and `matter` must outlive it. `sampler` is null where light is scattered by a phase
  /// function.
  DirectionalMedium(const Problem& problem, const RayMatter& matter, int region, int band,
                    std::unique_ptr<DirectionSampler> sampler);

  /// In the mean over a cell; of scattering, the rate at which the sampler is to be asked.
  PathCoefficients coefficients(CellIndex cell, const Vec3& travel) const {
    if (meeting_rate_ == 0) return matter_.along(cell, band_, travel);
    const double absorption = absorbs_by_direction_ ? matter_.along(cell, band_, travel).absorption
                                                    : problem_.absorption(cell, static_cast<int>(band_));
    return {absorption, meeting_rate_};
  }
  const DirectionSampler* sampler() const { return sampler_.get(); }

 private:
  const Problem& problem_;
  const RayMatter& matter_;
  std::size_t band_;
  bool absorbs_by_direction_;
  std::unique_ptr<DirectionSampler> sampler_;
  double meeting_rate_;
};

/// All of them in a problem.
class DirectionalMedia {
 public:
  /// The problem must outlive it. Throws InputError, naming the medium, the point and the direction, where
  /// absorption by a formula is negative or not finite in a direction of a small set, or a kernel is.
  explicit DirectionalMedia(const Problem& problem);

  bool empty() const { return matter_ == nullptr; }
  /// Draws from kernels at which a kernel was larger than it was taken to be at most, and all draws.
  std::pair<std::int64_t, std::int64_t> beyond_bounds() const;
  /// Null where nothing depends on the direction.
  const DirectionalMedium* of(int region, int band) const {
    return empty() ? nullptr : media_[static_cast<std::size_t>(region * bands_ + band)].get();
  }

 private:
  int bands_;
  std::unique_ptr<const RayMatter> matter_;
  std::vector<std::unique_ptr<const DirectionalMedium>> media_;  ///< [region][band]
  std::vector<const KernelSampler*> kernels_;
};

/// Returns whether histories may go back along the light with the scattering that they have forwards: a
/// kernel must claim to be reciprocal.
bool is_reciprocal(const Problem& problem);

/// Returns whether absorption or scattering depends on the direction anywhere.
bool depends_on_direction(const Problem& problem);

}  // namespace etendue
