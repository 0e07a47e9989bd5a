// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "solver/transport/acceleration/diffusive_medium.h"
#include "solver/transport/diffusion/diffusion_solver.h"
#include "solver/transport/sweep/transport_sweep.h"

namespace etendue {

/// Diffusion synthetic acceleration (Alcouffe 1977; Wang and Ragusa 2010), equations (D1) to (D6) of
/// docs/theory/iteration.md: P r = r + the light that a residual r becomes by scattering and reflection,
/// found by diffusion. So P approximates the inverse of I - T, and |P r| is an estimate of the error. It acts
/// on the fluence and on light at reflecting walls.
class DiffusionAcceleration {
 public:
  /// The arguments must outlive it. `extinction` is [cell][band] [1/length]. May do one sweep. With constant
  /// elements D includes what these diffuse by themselves.
  DiffusionAcceleration(const Problem& problem, TransportSweep& sweep, std::span<const double> extinction,
                        DiffusionLength length = DiffusionLength::automatic);

  /// Whether there is a low-order solver in this band. Where there is none P = I, and |P r| is no more an
  /// estimate of the error than |r|.
  bool acts_on(std::size_t band) const { return solvers_[solver_of_[band]] != nullptr; }
  /// Factor of |P r| in the estimate of the error, (D6). P does not bring the current of a
  /// residual into balance with forward scattering, which makes it 1/(1 - albedo g) times as large.
  double caution(std::size_t band) const { return caution_[band]; }
  /// corrected = P residual, in the bands that are `active`.
  void apply(const TransportState& residual, TransportState& corrected, const std::vector<char>& active);

  int sweeps() const { return sweeps_; }  ///< done for the diffusion coefficient
  int solver_count() const { return static_cast<int>(solvers_.size()); }
  double seconds() const { return seconds_; }              ///< in apply()
  double setup_seconds() const { return setup_seconds_; }  ///< sweeps left out
  /// Notes on the diffusion coefficient, and on bands without acceleration, with the reason.
  std::vector<std::string> notes() const;

 private:
  bool wants_nonlocal() const;
  double free_path(CellIndex cell, std::size_t band, const TransportState* path) const;
  double imaginary_extinction(std::size_t cell, std::size_t band) const;
  /// Addition of complex radiances to the absorption of P at [cell][band] [1/length]: P is made of A + K,
  /// (D7) of docs/theory/iteration.md.
  double added_absorption(std::size_t at) const;
  DiffusionCoefficients coefficients(std::size_t band, const TransportState* path);
  NodalVector approximate(std::size_t band, const NodalVector& right);
  /// Of the bands `band` and `band` + 1, the real and the imaginary part of one radiance.
  void correct_pair(std::size_t band, const TransportState& residual, TransportState& corrected);
  void add_correction(std::size_t band, const NodalVector& correction, const TransportState& residual,
                      TransportState& corrected) const;
  /// 0 where no ordinate meets the wall, as above and below a problem of the plane.
  double reflectance_seen(FaceIndex face, std::size_t band) const;
  const DiffusiveMedium& medium(CellIndex cell, std::size_t band) const;
  NodalVector scattered(std::size_t band, const TransportState& residual) const;
  NodalVector right_side(std::size_t band, const TransportState& residual) const;
  Eigen::Vector3d slope(CellIndex cell, std::size_t band, const NodalVector& correction) const;
  void correct_moments(std::size_t band, const NodalVector& correction, TransportState& corrected) const;
  void correct_radiance(std::size_t band, const NodalVector& correction, TransportState& corrected) const;
  void correct_walls(std::size_t band, const NodalVector& correction, const TransportState& residual,
                     TransportState& corrected) const;

  /// Where a state has the fluence at a corner; constants have one value for all corners.
  std::size_t at_corner(std::size_t cell, std::size_t corner, std::size_t band) const {
    return (cell * nodes_ + corner % nodes_) * static_cast<std::size_t>(sweep_.cells().stride()) + band;
  }
  double share_of_corner() const { return static_cast<double>(nodes_) / 4; }

  const Problem& problem_;
  TransportSweep& sweep_;
  std::size_t nodes_;  ///< of a cell: 4, or 1
  VertexSpace vertices_;
  std::vector<DiffusiveMedium> media_;  ///< [region * bands + band]
  std::vector<double> extinction_;      ///< [cell][band] that the mean ordinate sees [1/length]
  std::vector<double> caution_;         ///< [band]
  std::vector<double> free_paths_;      ///< [cell][band] [length]
  std::vector<std::size_t> solver_of_;  ///< [band]
  std::vector<std::unique_ptr<DiffusionSolver>> solvers_;  ///< null where there is a fault
  std::vector<std::string> faults_;                        ///< [solver] why it is null
  double longest_free_path_ = 0;                           ///< [length]
  bool nonlocal_ = false;
  int sweeps_ = 0;
  double seconds_ = 0;
  double setup_seconds_ = 0;
};

}  // namespace etendue
