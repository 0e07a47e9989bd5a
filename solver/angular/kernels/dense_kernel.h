// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "solver/angular/sets/direction_set.h"
#include "solver/materials/phase/phase_function.h"

namespace etendue {

/// Scattering between the ordinates of a set as a matrix. Light that scatters from an ordinate into itself
/// goes on as it was: it is no collision. So the matrix has no diagonal, and the extinction counts only what
/// leaves an ordinate for the others (docs/theory/scattering.md):
///
///     w_m.grad u_m + (sigma_a + leaving_m) u_m = sum over n != m of rate(m, n) w_n u_n + q.
struct DenseKernel {
  /// [into][from] k(w_from -> w_into), 0 on the diagonal. Of a phase function [1/sr]; of a kernel that has a
  /// scattering coefficient in it [1/(length sr)].
  Eigen::MatrixXd rate;
  /// [ordinate] sum over m of w_m rate(m, ordinate): what is scattered into others. Of a phase function the
  /// part of the scattered light that leaves, 1 - beta; beta < 0 where ordinates stand closely.
  std::vector<double> leaving;
  /// [ordinate] all that is scattered, straight ahead too, by its own integral and not by sums over the
  /// matrix: 1 of a phase function.
  std::vector<double> total;
  /// [ordinate] light scattered straight ahead: the diagonal that was taken out, or where the matrix cannot
  /// resolve it, total - leaving.
  std::vector<double> ahead;
  /// [ordinate] the momentum that the scattered light loses, by its own integral: 1 - g of a phase function.
  /// Empty where nothing is scaled to it.
  std::vector<double> transfer;
  /// By how much of itself `total` or `transfer` may be off: 0 for closed forms, else that of a quadrature.
  double uncertainty = 0;
};

/// The matrix of a phase function, scaled so that energy and mean cosine are exact:
///
///     K_mn = b_m p(w_m.w_n) b_n,   b_m sum over n of w_n p_mn (1 - w_m.w_n) b_n = 1 - g.
///
/// Light in the forward cell, where p is not resolved, has (1 - cos) = 0: it does not enter the condition,
/// and follows from energy as beta_m = 1 - sum over n != m of w_n K_mn. K is symmetric, and not negative
/// where p is not.
DenseKernel dense_kernel(const PhaseFunction& phase, const DirectionSet& set);

/// Galerkin quadrature (Morel 1989; Sanchez and Ragusa 2011): as many harmonics as ordinates, orthonormal on
/// the set, each with the Legendre moment of its degree. Scattering straight ahead is exact; the matrix of a
/// peaked phase function has negative entries.
DenseKernel galerkin_kernel(const PhaseFunction& phase, const DirectionSet& set);

/// Scales a matrix [into][from], whose diagonal does not count, so that from every ordinate n the momentum
/// transfer sum over m of w_m rate(m, n) (1 - w_m.w_n) is transfer[n]. A matrix that is symmetric stays so,
/// by factors b_m rate(m, n) b_n, and so does one that is reciprocal, rate(from w into v) = rate(from -v into
/// -w), by factors b_m rate(m, n) b_(-n). Others are scaled column by column, and so are those for which such
/// factors do not exist where `keep` is `if_possible`. Throws InputError where no scaling exists, with the
/// direction where one is at fault.
enum class KeepSymmetry { always, if_possible };
void scale_to_momentum_transfer(Eigen::MatrixXd& rate, const std::vector<double>& transfer,
                                const DirectionSet& set, KeepSymmetry keep = KeepSymmetry::always);

/// Scales a symmetric matrix, diagonal included, by b_m rate(m, n) b_n so that sum over m of w_m rate(m, n)
/// is total[n].
void scale_to_row_sums(Eigen::MatrixXd& rate, const std::vector<double>& total, const DirectionSet& set);

/// Takes the diagonal out, as scattering straight ahead, and sums up the rest; `total` by ordinate.
DenseKernel without_diagonal(Eigen::MatrixXd rate, std::vector<double> total, const DirectionSet& set);

/// Of a matrix scaled to a momentum transfer: scattering straight ahead follows from the total.
DenseKernel with_forward_part(Eigen::MatrixXd rate, std::vector<double> total, std::vector<double> transfer,
                              const DirectionSet& set);

/// What a matrix does to energy, to momentum and to signs.
struct DenseAccuracy {
  double asymmetry = 0;  ///< mean cosine, forward part included, of what scatters of isotropic light
  /// Largest difference, relative to `total`, between three figures of an ordinate: what the extinction
  /// counts as scattered (leaving + ahead), what the matrix sends into others, with what goes ahead, and the
  /// integral of the kernel (total); of a symmetric matrix also between what leaves an ordinate and what
  /// arrives at it where all radiances are equal. The doubt about the integral is added.
  double energy_error = 0;
  /// Largest difference between the momentum that the matrix takes from an ordinate and `transfer`, relative
  /// to it, with the doubt; 0 where there is no such figure.
  double momentum_error = 0;
  /// Largest |k(w -> v) - k(-v -> -w)| relative to the largest entry.
  double reciprocity_error = 0;
  double smallest_forward = 0;  ///< beta, the part scattered straight ahead
  double largest_forward = 0;
  double smallest = 0;        ///< entry, relative to the mean of all
  double negative_share = 0;  ///< sum of |negative entries| over that of all
};
DenseAccuracy dense_accuracy(const DenseKernel& kernel, const DirectionSet& set);

}  // namespace etendue
