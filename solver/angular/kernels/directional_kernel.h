// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/angular/kernels/dense_kernel.h"
#include "solver/materials/kernels/directional_scattering.h"

namespace etendue {

/// A medium that depends on the directions themselves, on a set of them, for a density of 1.
struct DirectionalKernel {
  DenseKernel kernel;
  /// [ordinate] absorption coefficient; empty where the medium's own, the same in all directions, holds.
  std::vector<double> absorbing;
  /// Value of the medium's coefficients (absorption + scattering, or scattering alone where `absorbing` is
  /// empty) are for this density in the mean over directions.
  double reference = 1;
};

/// Throws InputError (without a file) where a kernel is negative, takes more than the extinction, or is not
/// reciprocal though that is claimed; it names the directions.
DirectionalKernel directional_kernel(const DirectionalScattering& scattering, const DirectionSet& set);

}  // namespace etendue
