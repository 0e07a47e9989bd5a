// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <complex>
#include <numbers>
#include <optional>
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

/// A step in time.
struct StepInTime {
  double end = 0;              ///< [time]
  double error = 0;            ///< of the fluence, relative, as that of one step (TimeStep::error)
  double imbalance = 0;        ///< of the energy, or of stored heat [power time]
  std::vector<double> values;  ///< [quantity] at its end
  std::vector<double> errors;  ///< [quantity] of this step; empty: not known
};

/// A field at a time.
struct FrameInTime {
  double time = 0;
  /// [cell][4][band] fluence [power/length^2], or [cell][4] temperature [K]
  std::vector<double> values;
};

/// When light comes.
struct FlightTime {
  double mean = 0;       ///< [time]
  double deviation = 0;  ///< square root of the variance [time]
};

struct StepsInTime {
  std::string of = "fluence";  ///< what frames and errors of steps are of: "fluence" or "temperature"
  std::vector<TimeQuantity> quantities;
  std::vector<StepInTime> steps;
  std::vector<FrameInTime> frames;
  double largest_energy = 0;  ///< of all steps and bands, or stored heat [power time]

  /// The largest imbalance of the energy, relative to the largest energy.
  double imbalance() const {
    double largest = 0;
    for (const StepInTime& step : steps) largest = std::max(largest, step.imbalance);
    return largest_energy > 0 ? largest / largest_energy : 0;
  }
  int sweeps = 0;     ///< of the step that took most
  std::string fault;  ///< why they ended before their time; empty: they did not
};

/// What a run found about light that changes with time.
struct TimeResult {
  std::vector<TimeQuantity> quantities;
  std::vector<ModulatedLight> modulated;            ///< the first that of frequency 0; empty: not asked
  std::vector<std::vector<ValueInTime>> histories;  ///< [quantity][time]; empty: not asked
  std::vector<FlightTime> flight_times;             ///< [quantity]; empty: not asked
  std::optional<StepsInTime> steps;                 ///< empty: not asked
  int rates = 0;                                    ///< that were solved for
  int sweeps = 0;                                   ///< of the rate that took most
  double residual = 0;                              ///< the largest of rates and steps
  bool converged = true;
  bool interrupted = false;
  double seconds = 0;
};

}  // namespace etendue
