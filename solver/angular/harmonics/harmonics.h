// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "solver/angular/sets/direction_set.h"
#include "solver/materials/phase/phase_function.h"

namespace etendue {

/// Real spherical harmonics on the ordinates of a set, orthonormalised there degree by degree:
///
///     sum over m of w_m Y_j(m) Y_k(m) = 4 pi delta_jk      (2 pi in the plane).
///
/// Raw harmonics of degree 4 and more are not orthogonal on most sets, and scattering through them gains or
/// loses energy; these conserve it, and the mean cosine, to rounding on every set. Y_0 = 1, and Y_1, Y_2, Y_3
/// are sqrt 3 times x, y, z; in the plane Y_1, Y_2 are sqrt 2 times x, y. A function that depends on those
/// before it on this set is left out.
///
/// Scattering with moments chi_l (phase_moment) sends into ordinate m the source
///
///     S(m) = sigma_s/(4 pi) sum over k of chi_degree(k) Y_k(m) phi_k,   phi_k = sum over n of w_n Y_k(n)
///     u_n
///
/// and in the plane sigma_s/(2 pi) stands before the sum.
class DiscreteHarmonics {
 public:
  DiscreteHarmonics(const DirectionSet& set, int degree);

  /// Functions that were kept.
  int count() const { return static_cast<int>(degrees_.size()); }
  int degree_of(int k) const { return degrees_[static_cast<std::size_t>(k)]; }
  double value(int k, OrdinateIndex m) const { return of(m)[static_cast<std::size_t>(k)]; }
  /// All functions at one ordinate, [k].
  std::span<const double> of(OrdinateIndex m) const {
    return std::span(values_).subspan(m.at() * degrees_.size(), degrees_.size());
  }
  /// The highest degree up to which no function was left out.
  int full_degree() const;

 private:
  AngularSpace space_;
  std::vector<int> degrees_;    ///< [k]
  std::vector<double> values_;  ///< [ordinate][k]
};

/// As many harmonics as the set has ordinates: those of the lowest degrees that are independent on it.
DiscreteHarmonics complete_harmonics(const DirectionSet& set);

/// The highest degree that a person may want. The recurrences of the functions are stable far beyond (the
/// addition theorem holds to 1e-11 at degree 128), but a set that resolves degree 128 has 16,641 directions
/// or more, and as many moments at every node.
inline constexpr int highest_given_degree = 128;

/// How far the Legendre series of scattering is carried, and why.
struct ScatteringDegree {
  int degree = 0;
  std::string reason;
};

/// 0 for isotropic scattering; else the smallest degree L >= 1 beyond which every moment up to degree 8 is at
/// most 0.02 (|g|^(L+1) for Henyey and Greenstein), at most 7 and at most what the set resolves.
ScatteringDegree scattering_degree(const PhaseFunction& phase, const DirectionSet& set);

/// The degree that a person wants, or all that the set resolves below it.
ScatteringDegree given_degree(int degree, const PhaseFunction& phase, const DirectionSet& set);

/// Returns whether every moment beyond this degree (up to 8) is small enough to be left out.
bool is_negligible_beyond(const PhaseFunction& phase, int degree);

/// What scattering became on a set.
struct ScatteringAccuracy {
  double asymmetry = 0;       ///< mean cosine, averaged over the ordinates
  double energy_error = 0;    ///< largest |row sum - 1|
  double smallest = 0;        ///< value of the kernel, relative to isotropic scattering
  double negative_share = 0;  ///< integral of |negative values| over that of all
};
/// Of a series cut at this degree. `forward` is a part f of the light that is taken as not scattered
/// (delta-M, Wiscombe 1977): the moments are then (chi_l - f)/(1 - f), and the asymmetry counts that part in.
ScatteringAccuracy scattering_accuracy(const PhaseFunction& phase, int degree, const DirectionSet& set,
                                       double forward = 0);

/// Moment l of what is scattered when the part `forward` is not.
double reduced_moment(const PhaseFunction& phase, int degree, double forward);

}  // namespace etendue
