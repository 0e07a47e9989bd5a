// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "solver/angle/direction_set.h"
#include "solver/angle/spherical_harmonics.h"
#include "solver/problem/phase_function.h"

namespace etendue {
namespace {

using std::numbers::pi;

/// Highest degree up to which every harmonic but the first integrates to zero.
int exact_degree(const DirectionSet& set) {
  constexpr int highest = 63;
  constexpr double tolerance = 1e-9;
  std::vector<double> integrals(harmonic_count(highest), 0.0), values(integrals.size());
  for (std::size_t m = 0; m < set.directions().size(); ++m) {
    spherical_harmonics(set.directions()[m], highest, values);
    for (std::size_t k = 0; k < values.size(); ++k) integrals[k] += set.weights()[m] * values[k];
  }
  for (int k = 1; k < harmonic_count(highest); ++k)
    if (std::abs(integrals[static_cast<std::size_t>(k)]) > tolerance)
      return static_cast<int>(std::sqrt(k)) - 1;
  return highest;
}

/// A direction with the same probability in every solid angle; the same numbers on every machine.
Vec3 random_direction(std::mt19937_64& random) {
  const auto uniform = [&random] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  const double z = 2 * uniform() - 1, azimuth = 2 * pi * uniform(), radius = std::sqrt(1 - z * z);
  return {radius * std::cos(azimuth), radius * std::sin(azimuth), z};
}

double half_range_error_rms(const DirectionSet& set) {
  constexpr int normals = 2000;
  std::mt19937_64 random(1);
  double sum = 0;
  for (int i = 0; i < normals; ++i) {
    const double error = set.half_range(random_direction(random)) / pi - 1;
    sum += error * error;
  }
  return std::sqrt(sum / normals);
}

/// Largest error of the integral of a Henyey-Greenstein function about an ordinate, over all ordinates of a
/// set of up to 4,000 and evenly spaced ones of a larger set.
double kernel_row_error(const DirectionSet& set) {
  const PhaseFunction phase = PhaseHenyeyGreenstein{0.8};
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
  const double mean = 4 * pi / set.count();
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
  report.second_moment_error = (second - 4 * pi / 3 * Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();

  report.degree = exact_degree(set);
  for (int axis = 0; axis < 3; ++axis)
    report.axis_half_range_error[static_cast<std::size_t>(axis)] =
        std::abs(set.half_range(Vec3::Unit(axis)) / pi - 1);
  report.half_range_error_rms = half_range_error_rms(set);
  report.kernel_row_error = kernel_row_error(set);
  return report;
}

}  // namespace etendue
