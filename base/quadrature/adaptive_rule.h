// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>

namespace etendue {

/// The 15-point Kronrod rule and the 7-point Gauss rule within it: nodes, their weights in both.
struct KronrodPoint {
  double node, weight, gauss_weight;
};

/// Half of the points, the other half is at -node; the last is in the middle (Piessens, de Doncker-Kapenga,
/// Überhuber, Kahaner 1983, QUADPACK, rule qk15).
inline constexpr std::array<KronrodPoint, 8> kronrod_points = {{
    {0.991455371120812639206854697526329, 0.022935322010529224963732008058970, 0},
    {0.949107912342758524526189684047851, 0.063092092629978553290700663189204,
     0.129484966168869693270611432679082},
    {0.864864423359769072789712788640926, 0.104790010322250183839876322541518, 0},
    {0.741531185599394439863864773280788, 0.140653259715525918745189590510238,
     0.279705391489276667901467771423780},
    {0.586087235467691130294144691693680, 0.169004726639267902826583426598550, 0},
    {0.405845151377397166906606412076961, 0.190350578064785409913256402421014,
     0.381830050505118944950369775488975},
    {0.207784955007898467600689403773245, 0.204432940075298892414161999234649, 0},
    {0, 0.209482141084727828012999174891714, 0.417959183673469387755102040816327},
}};

/// Halvings of an interval: where the integrand is as s ln s, each makes the error a quarter.
inline constexpr int deepest_halving = 40;

/// Integral of f from a to b to an absolute tolerance.
template <class Function>
double adaptive_integral(const Function& f, double a, double b, double tolerance, int depth = 0) {
  const double middle = (a + b) / 2, half = (b - a) / 2;
  double kronrod = 0, gauss = 0;
  for (const KronrodPoint& point : kronrod_points) {
    const double value =
        point.node > 0 ? f(middle - half * point.node) + f(middle + half * point.node) : f(middle);
    kronrod += point.weight * value;
    gauss += point.gauss_weight * value;
  }
  if (half * std::abs(kronrod - gauss) <= tolerance || depth == deepest_halving) return half * kronrod;
  return adaptive_integral(f, a, middle, tolerance / 2, depth + 1) +
         adaptive_integral(f, middle, b, tolerance / 2, depth + 1);
}

}  // namespace etendue
