// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "solver/transport/scattering/dense_scattering.h"
#include "solver/transport/scattering/scattering_plan.h"

namespace etendue {

/// What diffusion knows of scattering in one medium and band: its first moment. Where light is diffuse,
///
///     u_m = (phi - path (slope grad phi) . omega_m) / 4 pi,
///
/// with the mean free path of the mean ordinate, and the moments of the transport equation on omega give
/// slope = B^-1 A and the diffusion tensor path A B^-1 A, where A = sum of w omega omega^T / 4 pi and
/// B = sum of w omega (extinction - scattering) omega^T / 4 pi for a mean extinction of 1
/// (docs/theory/iteration.md, D11). Of a phase function slope = 1/(1 - albedo g), and isotropic scattering
/// has 1 and 1/3.
struct DiffusiveMedium {
  Eigen::Matrix3d slope = Eigen::Matrix3d::Identity();
  Eigen::Matrix3d diffusion = Eigen::Matrix3d::Identity() / 3;
  double scattered = 1;  ///< of what the medium scatters, the part that does not go straight ahead
  /// [ordinate] what scatters of radiance by a matrix, w included, for a scattering coefficient of 1; else
  /// empty.
  std::vector<double> scattered_of;

  bool is_dense() const { return !scattered_of.empty(); }
};

/// [region * bands + band].
std::vector<DiffusiveMedium> diffusive_media(const Problem& problem, const DirectionSet& directions,
                                             const std::vector<ScatteringTreatment>& plan,
                                             const std::vector<DenseGroup>& groups);

}  // namespace etendue
