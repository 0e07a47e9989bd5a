// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/materials/surfaces/reflectance.h"

namespace etendue {

/// What a facet reflects of light from the angle d off its normal.
enum class FacetFresnel {
  constant,  ///< the same from all angles
  schlick    ///< r + (1 - r)(1 - cos d)^5 (Schlick 1994)
};

/// A rough surface of small mirrors (Torrance and Sparrow 1967) with the slopes of Trowbridge and Reitz
/// (1975), called GGX (Walter et al. 2007, eqs. 20, 33 and 34):
///
///     f_r = F D G/(4 cos_i cos_o),   D = a^2/(pi ((a^2 - 1) cos_h^2 + 1)^2),   G = 1/(1 + L_i + L_o),
///     L = (sqrt(1 + a^2 tan^2) - 1)/2,
///
/// h the direction half-way between i and o, and G of Smith with heights in common (Heitz 2014, eq. 99).
/// Light that meets a second facet is taken as lost, so that a rough surface reflects less than F.
class Microfacets : public Reflectance {
 public:
  /// `reflectance` r of a facet met along its normal, from 0 to 1; `roughness` a above 0, at most 1.
  Microfacets(double reflectance, double roughness, FacetFresnel fresnel);

  double value(double cos_in, double cos_out, double between) const override;
  ReflectedRay sample(double cos_in, double u, double v) const override;

 private:
  double of_facet(double cosine) const;
  double masking(double cosine) const;
  double mean_weight(double cos_in) const;

  double reflectance_, roughness_;
  FacetFresnel fresnel_;
};

}  // namespace etendue
