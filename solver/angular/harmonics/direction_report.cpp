// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/angular/harmonics/direction_report.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "base/angular_space.h"
#include "solver/angular/harmonics/spherical_harmonics.h"
#include "solver/materials/phase/phase_function.h"

namespace etendue {
namespace {

using std::numbers::pi;

/// Highest degree up to which every harmonic but the first integrates to zero.
int exact_degree(const DirectionSet& set) {
  constexpr int highest = 159;
  constexpr double tolerance = 1e-9;
  // Most sets end early: degrees are checked in steps that double.
  for (int degree = 9;; degree = std::min(2 * degree + 1, highest)) {
    const auto count = static_cast<std::size_t>(harmonic_count(set.space(), degree));
    std::vector<double> integrals(count, 0.0), values(count);
    for (std::size_t m = 0; m < set.directions().size(); ++m) {
      harmonics(set.space(), set.directions()[m], degree, values);
      for (std::size_t k = 0; k < count; ++k) integrals[k] += set.weights()[m] * values[k];
    }
    int l = 1;
    for (std::size_t k = 1; k < count; ++k) {
      if (k == static_cast<std::size_t>(harmonic_count(set.space(), l))) ++l;
      if (std::abs(integrals[k]) > tolerance) return l - 1;
    }
    if (degree == highest) return highest;
  }
}

/// A direction with the same probability in every solid angle, or angle of the plane; the same numbers on
/// every machine.
Vec3 random_direction(std::mt19937_64& random, AngularSpace space) {
  const auto uniform = [&random] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  const double z = space == AngularSpace::sphere ? 2 * uniform() - 1 : 0, azimuth = 2 * pi * uniform(),
               radius = std::sqrt(1 - z * z);
  return {radius * std::cos(azimuth), radius * std::sin(azimuth), z};
}

double half_range_error_rms(const DirectionSet& set) {
  constexpr int normals = 2000;
  std::mt19937_64 random(1);
  double sum = 0;
  for (int i = 0; i < normals; ++i) {
    const double error = set.half_range(random_direction(random, set.space())) / half_range(set.space()) - 1;
    sum += error * error;
  }
  return std::sqrt(sum / normals);
}

/// Largest error of the integral of a Henyey-Greenstein function about an ordinate, over all ordinates of a
/// set of up to 4,000 and evenly spaced ones of a larger set.
double kernel_row_error(const DirectionSet& set) {
  PhaseFunction phase = PhaseHenyeyGreenstein{0.8};
  if (set.space() == AngularSpace::plane) phase = in_plane(phase);
  const int stride = std::max(1, set.count() / 2000);
  double largest = 0;
  for (int m = 0; m < set.count(); m += stride) {
    double sum = 0;
    for (int n = 0; n < set.count(); ++n) {
      const OrdinateIndex from(m), to(n);
      sum += set.weight(to) * phase_value(phase, set.direction(from).dot(set.direction(to)));
    }
    largest = std::max(largest, std::abs(sum - 1));
  }
  return largest;
}

}  // namespace

DirectionSetReport report_directions(const DirectionSet& set) {
  DirectionSetReport report;
  report.count = set.count();
  const auto [smallest, largest] = std::minmax_element(set.weights().begin(), set.weights().end());
  const double mean = full_range(set.space()) / set.count();
  report.smallest_weight = *smallest / mean;
  report.largest_weight = *largest / mean;

  Vec3 first = Vec3::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (std::size_t m = 0; m < set.directions().size(); ++m) {
    const Vec3& direction = set.directions()[m];
    first += set.weights()[m] * direction;
    second += set.weights()[m] * direction * direction.transpose();
  }
  report.first_moment_error = first.norm();
  Eigen::Matrix3d exact = Eigen::Matrix3d::Identity() * full_range(set.space()) / dimension(set.space());
  if (set.space() == AngularSpace::plane) exact(2, 2) = 0;
  report.second_moment_error = (second - exact).cwiseAbs().maxCoeff();

  report.degree = exact_degree(set);
  for (int axis = 0; axis < dimension(set.space()); ++axis)
    report.axis_half_range_error[static_cast<std::size_t>(axis)] =
        std::abs(set.half_range(Vec3::Unit(axis)) / half_range(set.space()) - 1);
  report.half_range_error_rms = half_range_error_rms(set);
  report.kernel_row_error = kernel_row_error(set);
  return report;
}

}  // namespace etendue
