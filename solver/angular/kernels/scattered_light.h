// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>
#include <utility>
#include <vector>

#include "solver/angular/sets/direction_set.h"
#include "solver/materials/kernels/directional_scattering.h"
#include "solver/materials/kernels/leaf_canopy.h"

namespace etendue {

/// k(before -> after) of leaves (`normals` are theirs), flakes or a formula for a density of 1 [1/sr], as it
/// is beside straight ahead. A formula must not be evaluated by two threads at a time. Not of matrices.
double scattering_value(const DirectionalScattering& scattering, const LeafNormals& normals,
                        const Vec3& before, const Vec3& after);

/// Where light of any directions goes that a medium scatters which depends on the directions themselves: into
/// the ordinates of a set.
class ScatteredLight {
 public:
  /// Leaves, flakes or a formula. The set must outlive it.
  ScatteredLight(DirectionalScattering scattering, const DirectionSet& set);

  /// Light of thin beams: the direction in which each travels and its fluence.
  using Beams = std::vector<std::pair<Vec3, double>>;
  /// Writes the sum over beams of fluence times k(beam -> ordinate) [ordinate]. A formula must not be
  /// evaluated by two threads at a time.
  void scatter(const Beams& beams, std::span<double> values) const;

 private:
  void scatter_by_leaves(const LeafCanopy& leaves, const Beams& beams, std::span<double> values) const;

  DirectionalScattering scattering_;
  const DirectionSet& set_;
  LeafNormals normals_;
  Eigen::MatrixXd cosines_;  ///< of leaves: [normal][ordinate]
};

}  // namespace etendue
