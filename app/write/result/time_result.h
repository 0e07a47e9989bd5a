// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <complex>
#include <numbers>
#include <string>
#include <vector>

#include "solver/time/laplace_inversion.h"

namespace etendue {

/// By how much light of a complex amplitude comes later than that of the sources [degree], from -180 to 180:
/// it is the real part of A e^(i 2 pi f t), A = |A| e^(-i phase).
inline double phase_of(std::complex<double> amplitude) {
  // Not -0 where nothing comes later.
  return amplitude.imag() == 0 && amplitude.real() >= 0 ? 0 : -std::arg(amplitude) * 180 / std::numbers::pi;
}

/// A number that is read of light that changes with time.
struct TimeQuantity {
  std::string quantity;  ///< "fluence", "irradiance", "incoming", "absorbed", …
  std::string name;      ///< "probe axis 3", "sensor desk", "wall floor", "region smoke"
  std::string band;
  std::string unit;
};

/// Light at one frequency.
struct ModulatedLight {
  double frequency = 0;                      ///< [1/time]; 0: its mean
  std::vector<std::complex<double>> values;  ///< [quantity]
  /// [cell][4][band][real, imaginary part] [power/length^2]
  std::vector<double> fluence;
};

/// What a run found about light that changes with time.
struct TimeResult {
  std::vector<TimeQuantity> quantities;
  std::vector<ModulatedLight> modulated;            ///< the first that of frequency 0; empty: not asked
  std::vector<std::vector<ValueInTime>> histories;  ///< [quantity][time]; empty: not asked
  int rates = 0;                                    ///< that were solved for
  int sweeps = 0;                                   ///< of the rate that took most
  double residual = 0;                              ///< the largest
  bool converged = true;
  bool interrupted = false;
  double seconds = 0;
};

}  // namespace etendue
