// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "solver/radiosity/extended/extended_exchange.h"

namespace etendue {

/// What passes from a patch of a sheet to one on its other side.
struct SheetPassage {
  std::size_t from, to;  ///< patches
  double share;          ///< area that they have in common, of that of `to`
};

/// B_j = E_j + rho_j H_j + tau_j sum over passages k to j of share H_k,  A_j H_j = sum over k of G_jk B_k.
/// G is extended over walls that redirect light, where there are any. Arrays are [patch][band].
struct RadiosityEquation {
  const Exchange& exchange;
  std::size_t bands = 1;
  std::vector<double> emission;     ///< E, exitance without reflection [power/length^2]
  std::vector<double> reflectance;  ///< rho
  std::vector<SheetPassage> passages = {};
  std::vector<double> transmittance = {};  ///< tau, where there are passages
  const ExtendedExchange* extended = nullptr;

  /// rho H + tau H(behind) of an irradiance H.
  std::vector<double> sent_on(const std::vector<double>& irradiance) const;
  /// G x
  std::vector<double> arriving(const std::vector<double>& x) const;
  /// [patch][band] of G_jk
  std::vector<double> row(std::size_t j) const;
  /// What walls redirect of light x, of which this power arrives [power/length^2].
  std::vector<double> redirected(const std::vector<double>& x, const std::vector<double>& arriving) const;
};

/// The powers of one band in one pass of the light from all walls to all walls.
struct Bounce {
  int pass = 0;
  std::size_t band = 0;
  double exitant = 0;   ///< power that leaves the walls: emitted in the first pass, reflected in later ones
  double incident = 0;  ///< power that arrives, again where a mirror or a glossy wall has redirected it
  double redirected = 0;
  double deposit = 0;  ///< what of it stays
};

/// A solution, or how far it is.
struct RadiosityState {
  std::vector<double> irradiance;  ///< H [patch][band] [power/length^2]
  /// What mirrors and glossy walls redirect of it [patch][band] [power/length^2].
  std::vector<double> redirected = {};
  std::vector<Bounce> bounces;   ///< pass by pass, band by band; none of a direct solution
  std::vector<double> residual;  ///< [band] power that is still to be reflected, of all that arrives
  int passes = 0;                ///< of gathering, or rows of shooting in units of all patches
  bool converged = false;
};

/// Receives each state of the iteration; returns whether to continue.
using RadiosityObserver = std::function<bool(const RadiosityState&)>;

struct RadiosityLimits {
  double tolerance = 1e-6;  ///< of the residual
  int most_passes = 500;
};

/// Patches up to which a direct solution is made: the matrix of each band is factorised.
inline constexpr std::size_t most_direct_patches = 4000;

/// By elimination, band by band.
RadiosityState solve_directly(const RadiosityEquation& equation);

/// Lets all walls gather again and again: after n passes it holds the light of n bounces, exactly.
RadiosityState solve_by_gathering(const RadiosityEquation& equation, const RadiosityLimits& limits,
                                  const RadiosityObserver& observer = {});

/// Lets the patch with the most unsent power send it, again and again (Cohen, Chen, Wallace, Greenberg 1988);
/// the observer looks once for each tenth of the patches.
RadiosityState solve_by_shooting(const RadiosityEquation& equation, const RadiosityLimits& limits,
                                 const RadiosityObserver& observer = {});

}  // namespace etendue
