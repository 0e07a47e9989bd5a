// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/kernels/kernel_formula.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/quadrature/sphere_cubature.h"
#include "base/quadrature/unit_rule.h"

namespace etendue {
namespace {

using std::numbers::pi;

/// Change from one rule to the next that ends the doubling. Rules that converge by factors are then exact to
/// rounding.
constexpr double settled = 1e-10;
/// What the adaptive rule is to reach; kinks across the axes are left with some 1e-6.
constexpr double wanted = 1e-7;
/// A kernel that is larger than this times its mean at a mirror image of a direction has a peak there that
/// rules around the direction may miss.
constexpr double peaked = 30;

/// Gauss-Legendre in t, 1 - cosine = 2 t^2 = 2 sin^2(angle/2), times equal azimuths: half of the points lie
/// within 60 degrees, and peaks become wide. The range is cut at right angles, where max(0, w.v) has a kink.
struct RingRule {
  std::vector<double> nodes, weights;  ///< of t
  int azimuths;
};

RingRule ring_rule(int turns, int azimuths) {
  const GaussRule half = unit_rule(turns / 2);
  const double cut = std::sqrt(0.5);
  RingRule rule{{}, {}, azimuths};
  for (const auto& [from, length] : {std::pair(0.0, cut), std::pair(cut, 1 - cut)})
    for (std::size_t i = 0; i < half.nodes.size(); ++i) {
      rule.nodes.push_back(from + length * half.nodes[i]);
      rule.weights.push_back(length * half.weights[i]);
    }
  return rule;
}

/// Each has no node and no azimuth of the others, and twice the last one's.
const std::array<RingRule, 4>& ring_rules() {
  static const std::array<RingRule, 4> rules = {ring_rule(12, 8), ring_rule(24, 16), ring_rule(48, 32),
                                                ring_rule(96, 64)};
  return rules;
}

OutgoingMoments summed(const KernelFormula& kernel, const Vec3& before, const RingRule& rule) {
  const Vec3 side = before.unitOrthogonal(), other = before.cross(side);
  OutgoingMoments sum;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const double t = rule.nodes[i], turned = 2 * t * t, sine = 2 * t * std::sqrt(1 - t * t);
    double ring = 0;
    for (int j = 0; j < rule.azimuths; ++j) {
      const double azimuth = 2 * pi * (j + 0.5) / rule.azimuths;
      ring += kernel.at(
          before, (1 - turned) * before + sine * (std::cos(azimuth) * side + std::sin(azimuth) * other));
    }
    const double part = rule.weights[i] * 4 * t * 2 * pi / rule.azimuths * ring;
    sum.scattered += part;
    sum.transfer += part * turned;
  }
  return sum;
}

/// 0 where both are, 1 where one is not finite.
double relative_change(double a, double b) {
  if (!std::isfinite(a) || !std::isfinite(b)) return 1;
  return a == b ? 0 : std::abs(a - b) / std::max(std::abs(a), std::abs(b));
}

/// The direction and its images in the coordinate planes, where formulas put mirrors and peaks.
std::vector<Vec3> images(const Vec3& w) {
  std::vector<Vec3> all;
  for (int octant = 0; octant < 8; ++octant)
    all.emplace_back(octant & 1 ? -w.x() : w.x(), octant & 2 ? -w.y() : w.y(), octant & 4 ? -w.z() : w.z());
  return all;
}

bool has_peak_elsewhere(const KernelFormula& kernel, const Vec3& before, double scattered) {
  for (const Vec3& image : images(before))
    if ((image - before).norm() > 1e-6 && kernel.at(before, image) * 4 * pi > peaked * scattered) return true;
  return false;
}

OutgoingMoments adaptive(const KernelFormula& kernel, const Vec3& before) {
  const auto moments = [&](const Vec3& after) -> std::array<double, 2> {
    const double k = kernel.at(before, after);
    return {k, k * 0.5 * (before - after).squaredNorm()};
  };
  const SphereIntegrals found = integrate_over_sphere(moments, images(before), wanted);
  OutgoingMoments result{found.values[0], found.values[1], 0};
  for (std::size_t i = 0; i < 2; ++i)
    if (found.errors[i] > 0 || !std::isfinite(found.values[i]))
      result.uncertainty = std::max(result.uncertainty, found.values[i] > 0 && std::isfinite(found.values[i])
                                                            ? found.errors[i] / found.values[i]
                                                            : 1);
  return result;
}

/// By rings alone, as far as they go.
OutgoingMoments by_rings(const KernelFormula& kernel, const Vec3& before) {
  OutgoingMoments last = summed(kernel, before, ring_rules().front());
  for (std::size_t i = 1; i < ring_rules().size(); ++i) {
    OutgoingMoments next = summed(kernel, before, ring_rules()[i]);
    next.uncertainty = std::max(relative_change(next.scattered, last.scattered),
                                relative_change(next.transfer, last.transfer));
    if (next.uncertainty <= settled) return next;
    last = next;
  }
  return last;
}

}  // namespace

OutgoingMoments outgoing_moments(const KernelFormula& kernel, const Vec3& before) {
  const OutgoingMoments rings = by_rings(kernel, before);
  const bool may_miss = has_peak_elsewhere(kernel, before, rings.scattered);
  if (rings.uncertainty <= settled && !may_miss) return rings;
  const OutgoingMoments finer = adaptive(kernel, before);
  return may_miss || finer.uncertainty < rings.uncertainty ? finer : rings;
}

double mean_scattering(const KernelFormula& kernel, int polar) {
  // The scattering coefficient is smooth in the direction: 8 x 16 of them suffice for its mean. Kinks cost it
  // digits, but it is for people to read: the matrix is scaled to the moments of its own ordinates.
  const GaussRule rule = unit_rule(polar);
  const int azimuths = 2 * polar;
  double sum = 0;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i)
    for (int j = 0; j < azimuths; ++j) {
      const double cosine = 2 * rule.nodes[i] - 1, sine = std::sqrt(1 - cosine * cosine);
      const double azimuth = 2 * pi * (j + 0.5) / azimuths;
      const Vec3 before(sine * std::cos(azimuth), sine * std::sin(azimuth), cosine);
      sum += rule.weights[i] / azimuths * by_rings(kernel, before).scattered;
    }
  return sum;
}

KernelFormula kernel_at(const KernelFormula& kernel, const Vec3& place) {
  KernelFormula copy = kernel;
  copy.formula = std::make_shared<const Expression>(*kernel.formula);
  copy.place = place;
  return copy;
}

}  // namespace etendue
