// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

namespace etendue {

/// Relative radiance of a sky that is a product of two functions: one of the zenith angle Z (gradation) and
/// one of the angle chi from the sun (indicatrix),
///   (1 + a exp(b/cos Z)) (k + c exp(d chi) + e cos^2 chi),
/// as in the CIE standard general sky (ISO 15469:2004) and in the model of Perez, Seals and Michalsky (1993).
struct SkyShape {
  double a = 0, b = -1, c = 0, d = -1, e = 0;
  double k = 1;

  /// At a zenith angle below pi/2 and an angle from the sun [rad].
  double radiance(double zenith_angle, double from_sun) const;
};

}  // namespace etendue
