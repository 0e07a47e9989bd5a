// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/acceleration/diffusive_medium.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>

#include "solver/angular/harmonics/harmonics.h"

namespace etendue {
namespace {

/// The least of a diffusion tensor's eigenvalues, relative to the largest, that is taken for diffusion.
constexpr double least_conductance = 1e-6;

/// Absorption over scattering in a region, in the mean; negative where nothing scatters.
double absorption_ratio(const Problem& problem, int region, int band) {
  double absorbed = 0, scattered = 0;
  for (std::int32_t c = 0; c < problem.mesh().cell_count(); ++c) {
    const CellIndex cell(c);
    if (problem.mesh().region(cell) != region) continue;
    absorbed += problem.mesh().volume(cell) * problem.absorption(cell, band);
    scattered += problem.mesh().volume(cell) * problem.scattering(cell, band);
  }
  return scattered > 0 ? absorbed / scattered : -1;
}

/// Sums over the ordinates of a set.
class Moments {
 public:
  explicit Moments(const DirectionSet& set)
      : set_(set),
        omega_(set.count(), 3),
        weights_(Eigen::Map<const Eigen::VectorXd>(set.weights().data(), set.count()) /
                 full_range(set.space())) {
    for (int m = 0; m < set.count(); ++m) omega_.row(m) = set.direction(OrdinateIndex(m)).transpose();
  }

  /// sum of w factor omega omega^T / 4 pi. In the plane z is filled in as x, so that it can be inverted.
  Eigen::Matrix3d second(const Eigen::VectorXd& factor) const {
    return filled(omega_.transpose() * weights_.cwiseProduct(factor).asDiagonal() * omega_);
  }
  Eigen::Matrix3d second() const { return second(Eigen::VectorXd::Ones(weights_.size())); }
  /// sum of w_m omega_m rate(m, n) w_n omega_n^T / 4 pi
  Eigen::Matrix3d scattered(const Eigen::MatrixXd& rate) const {
    const Eigen::MatrixXd from = weights_.asDiagonal() * omega_;
    return full_range(set_.space()) * from.transpose() * (rate * from);
  }

 private:
  Eigen::Matrix3d filled(Eigen::Matrix3d matrix) const {
    if (set_.space() == AngularSpace::plane) matrix(2, 2) = matrix(0, 0);
    return matrix;
  }

  const DirectionSet& set_;
  Eigen::MatrixX3d omega_;
  Eigen::VectorXd weights_;  ///< that sum to 1
};

/// Fills in what follows from B. Kernels that are not reciprocal may have no diffusion: they are taken as
/// isotropic.
void set_balance(const Eigen::Matrix3d& second, const Eigen::Matrix3d& balance, DiffusiveMedium& medium) {
  const Eigen::Matrix3d slope = balance.inverse() * second;
  const Eigen::Matrix3d tensor = second * slope;
  const Eigen::Matrix3d symmetric = (tensor + tensor.transpose()) / 2;
  const Eigen::Vector3d spectrum = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(symmetric).eigenvalues();
  medium.diffusion = second;
  if (!symmetric.allFinite() || spectrum(0) <= least_conductance * spectrum(2)) return;
  medium.slope = slope;
  medium.diffusion = symmetric;
}

/// Of scattering through moments: B = (1 - albedo g) A.
DiffusiveMedium medium_by_moments(const PhaseFunction& phase, const ScatteringTreatment& how, double ratio,
                                  const Moments& moments) {
  DiffusiveMedium medium;
  medium.scattered = 1 - how.forward;
  const double mean = how.degree > 0 ? reduced_moment(phase, 1, how.forward) : 0;
  const double albedo = medium.scattered / (medium.scattered + ratio);
  set_balance(moments.second(), (1 - albedo * mean) * moments.second(), medium);
  return medium;
}

DiffusiveMedium by_matrix(const DenseGroup& group, double ratio, const DirectionSet& directions,
                          const Moments& moments) {
  DiffusiveMedium medium;
  const bool absorbs = !group.directional.absorbing.empty();
  Eigen::VectorXd extinction(directions.count());
  for (Eigen::Index m = 0; m < extinction.size(); ++m)
    extinction(m) =
        group.extinction(static_cast<std::size_t>(m)) + (absorbs ? 0 : ratio * group.directional.reference);
  // The amplitude of the matrix for a scattering coefficient of 1.
  const double amplitude = (absorbs ? 1 + ratio : 1) / group.directional.reference;
  for (int m = 0; m < directions.count(); ++m)
    medium.scattered_of.push_back(amplitude * directions.weight(OrdinateIndex(m)) *
                                  group.kernel().leaving[static_cast<std::size_t>(m)]);
  const double mean = extinction.mean();
  set_balance(moments.second(), (moments.second(extinction) - moments.scattered(group.kernel().rate)) / mean,
              medium);
  return medium;
}

/// In the plane nothing goes along z.
void flatten(DiffusiveMedium& medium) {
  medium.diffusion.row(2).setZero();
  medium.diffusion.col(2).setZero();
  medium.slope.row(2).setZero();
  medium.slope.col(2).setZero();
}

}  // namespace

std::vector<DiffusiveMedium> diffusive_media(const Problem& problem, const DirectionSet& directions,
                                             const std::vector<ScatteringTreatment>& plan,
                                             const std::vector<DenseGroup>& groups) {
  const Moments moments(directions);
  std::vector<DiffusiveMedium> media;
  for (int region = 0; region < static_cast<int>(problem.media().size()); ++region)
    for (int band = 0; band < problem.band_count(); ++band) {
      const double ratio = absorption_ratio(problem, region, band);
      const ScatteringTreatment& how = plan[media.size()];
      const auto group = std::find_if(groups.begin(), groups.end(), [&](const DenseGroup& g) {
        return g.region == region && std::count(g.bands.begin(), g.bands.end(), band) > 0;
      });
      if (ratio < 0)
        media.push_back(medium_by_moments(PhaseIsotropic{}, {}, 0, moments));
      else if (group == groups.end())
        media.push_back(medium_by_moments(problem.medium(region).phase[static_cast<std::size_t>(band)], how,
                                          ratio, moments));
      else
        media.push_back(by_matrix(*group, ratio, directions, moments));
    }
  if (problem.space() == AngularSpace::plane)
    for (DiffusiveMedium& medium : media) flatten(medium);
  return media;
}

}  // namespace etendue
