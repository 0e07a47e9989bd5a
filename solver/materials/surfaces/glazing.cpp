// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/surfaces/glazing.h"

#include <cmath>

namespace etendue {
namespace {

/// What panes let through and reflect in one polarization.
struct Part {
  double transmitted;
  double reflected;
};

// Duffie and Beckman 2013, equations 5.3.1 and 5.3.2: `surface` is Fresnel's reflectance r of a surface,
// `passed` the part tau_a that absorption leaves on one passage.
Part pane(double surface, double passed) {
  const double round = surface * passed, through = 1 - surface;
  const double transmitted = passed * through * through / (1 - round * round);
  return {transmitted, surface + transmitted * round};
}

// Equal panes one behind the other: T = T_1 T_2/(1 - R_1 R_2), R = R_1 + T_1^2 R_2/(1 - R_1 R_2).
Part stack(const Part& one, int panes) {
  Part all = one;
  for (int i = 1; i < panes; ++i) {
    const double between = 1 - all.reflected * one.reflected;
    all = {all.transmitted * one.transmitted / between,
           one.reflected + one.transmitted * one.transmitted * all.reflected / between};
  }
  return all;
}

/// The mean over both polarizations; `cosine` is that outside of the glass.
Part unpolarized(double cosine, double index, double depth, int panes) {
  const double inside = std::sqrt(1 - (1 - cosine * cosine) / (index * index));
  const double across = (cosine - index * inside) / (cosine + index * inside);
  const double along = (index * cosine - inside) / (index * cosine + inside);
  const double passed = std::exp(-depth / inside);
  const Part s = stack(pane(across * across, passed), panes), p = stack(pane(along * along, passed), panes);
  return {(s.transmitted + p.transmitted) / 2, (s.reflected + p.reflected) / 2};
}

}  // namespace

double Glazing::clear_transmittance(double refractive_index, int panes) {
  return unpolarized(1, refractive_index, 0, panes).transmitted;
}

// The transmittance falls with the depth: halving finds it to rounding.
Glazing::Glazing(double normal_transmittance, double refractive_index, int panes)
    : index_(refractive_index), panes_(panes) {
  double low = 0, high = 1;
  while (unpolarized(1, index_, high, panes_).transmitted > normal_transmittance) high *= 2;
  constexpr int halvings = 60;
  for (int i = 0; i < halvings; ++i) {
    depth_ = (low + high) / 2;
    (unpolarized(1, index_, depth_, panes_).transmitted > normal_transmittance ? low : high) = depth_;
  }
}

double Glazing::transmittance(double cosine) const {
  return unpolarized(cosine, index_, depth_, panes_).transmitted;
}

double Glazing::reflectance(double cosine) const {
  return unpolarized(cosine, index_, depth_, panes_).reflected;
}

double Glazing::diffuse_transmittance() const {
  // Simpson's rule in mu^2, over which the transmittance rises steeply at the grazing end alone.
  constexpr int panels = 2000;
  double sum = 0;
  for (int i = 0; i < panels; ++i) {
    const auto at = [&](double x) { return transmittance(std::sqrt((i + x) / panels)); };
    sum += (at(0) + 4 * at(0.5) + at(1)) / (6 * panels);
  }
  return sum;
}

}  // namespace etendue
