// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

namespace etendue {

/// How scattering is discretised in angle. Automatic: moments where the series ends by itself, else the
/// matrix, where it fits.
enum class ScatteringBackend { automatic, moments, dense, galerkin };

/// What becomes of a peak of the phase function that the moments do not resolve. Delta-M counts it as light
/// that does not scatter. Automatic: delta-M where the truncated part is not small.
enum class ForwardPeak { automatic, keep, delta_m };

/// What is asked of the scattering in one medium and band.
struct ScatteringChoice {
  ScatteringBackend backend = ScatteringBackend::automatic;
  int degree = -1;  ///< of the moments; -1: as the phase function asks
  ForwardPeak peak = ForwardPeak::automatic;
};

}  // namespace etendue
