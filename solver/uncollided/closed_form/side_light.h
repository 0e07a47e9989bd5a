// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

namespace etendue {

/// A side of a flat shape seen from above its plane. Lengths are from the foot of the eye in the plane.
struct SeenSide {
  double height;  ///< of the eye above the plane, positive [length]
  double
      distance;  ///< of the line of the side; positive if it turns counterclockwise about the foot [length]
  double first;  ///< where the side begins along that line, counted from its point nearest to the foot
  double last;   ///< where it ends; larger
};

/// E_2(ah) and E_3(ah) of the eye's own height, which all sides share.
struct FootIntegrals {
  FootIntegrals(double height, double extinction);
  double second, third;
};

/// What a side adds to the light of its shape through a homogeneous medium, over the radiance [sr].
struct SideLight {
  double fluence = 0;
  double upward = 0;   ///< of the net flux
  double outward = 0;  ///< of the net flux, in the plane
};

/// Light of radiance 1 through a medium of extinction a reaches an eye at height h from a shape A with r the
/// distance, rho the place from the foot and f the polar angle about it:
///
///     fluence   int_A h e^(-ar) / r^3 dA            = contour int E_2(ah) - (h / r) E_2(ar) df,
///     upward    int_A h^2 e^(-ar) / r^4 dA          = contour int E_3(ah) - (h / r)^2 E_3(ar) df,
///     in plane  -int_A h rho e^(-ar) / r^4 dA       = contour int (h / r^2) E_3(ar) n ds.
///
/// The first two follow from integration along the rays of the polar angle, the third from the theorem of
/// Gauss: the integrand is the gradient of (h / r^2) E_3(ar). All go over into Lambert's for a = 0.
/// `below` are the integrals of ah.
SideLight light_of_side(const SeenSide& side, double extinction, const FootIntegrals& below);

}  // namespace etendue
