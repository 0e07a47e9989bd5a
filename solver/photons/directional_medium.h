// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "solver/lights/ray_matter.h"
#include "solver/photons/direction_sampler.h"
#include "solver/problem/problem.h"

namespace etendue {

/// What a region does in one band to photons whose absorption or scattering depends on their direction.
class DirectionalMedium {
 public:
  /// `matter` must outlive it. `sampler` is null where a phase function says how light turns.
  DirectionalMedium(const RayMatter& matter, std::size_t band, std::unique_ptr<DirectionSampler> sampler)
      : matter_(matter), band_(band), sampler_(std::move(sampler)) {}

  PathCoefficients coefficients(CellIndex cell, const Vec3& travel) const {
    return matter_.along(cell, band_, travel);
  }
  const DirectionSampler* sampler() const { return sampler_.get(); }

 private:
  const RayMatter& matter_;
  std::size_t band_;
  std::unique_ptr<DirectionSampler> sampler_;
};

/// All of them in a problem.
class DirectionalMedia {
 public:
  /// The problem must outlive it. Throws InputError, naming the medium, the point and the direction, where
  /// absorption by a formula is negative or not finite in a direction of a small set.
  explicit DirectionalMedia(const Problem& problem);

  bool empty() const { return matter_ == nullptr; }
  /// Null where nothing depends on the direction.
  const DirectionalMedium* of(int region, int band) const {
    return empty() ? nullptr : media_[static_cast<std::size_t>(region * bands_ + band)].get();
  }

 private:
  int bands_;
  std::unique_ptr<const RayMatter> matter_;
  std::vector<std::unique_ptr<const DirectionalMedium>> media_;  ///< [region][band]
};

/// Whether absorption or scattering depends on the direction anywhere.
bool depends_on_direction(const Problem& problem);

}  // namespace etendue
