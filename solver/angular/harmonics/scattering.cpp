// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "solver/angular/harmonics/harmonics.h"

namespace etendue {
namespace {

// Beyond degree 7 the 64 moments per cell cost more than a finer set of directions gains.
constexpr int highest_degree = 7;
// Diffusely lit slabs of Henyey-Greenstein scatterers meet 0.5 % of the incident flux when the first moment
// left out is below this.
constexpr double negligible_moment = 0.02;

/// Why a degree was chosen; the moment is the first that is left out.
std::string reason_text(const char* why, int degree, double moment) {
  char text[160];
  std::snprintf(text, sizeof text, "%s; the moment of degree %d, %.2g, is the first left out", why,
                degree + 1, moment);
  return text;
}

/// Largest |moment| from degree + 1 to the highest that is evaluated.
double largest_beyond(const PhaseFunction& phase, int degree) {
  double largest = 0;
  for (int l = degree + 1; l <= std::max(highest_degree, degree) + 1; ++l)
    largest = std::max(largest, std::abs(phase_moment(phase, l)));
  return largest;
}

/// At most as many ordinates as this are sampled, evenly, for the signs of a kernel.
constexpr int most_looked_at = 200;

}  // namespace

double reduced_moment(const PhaseFunction& phase, int degree, double forward) {
  return (phase_moment(phase, degree) - forward) / (1 - forward);
}

bool is_negligible_beyond(const PhaseFunction& phase, int degree) {
  return largest_beyond(phase, degree) <= negligible_moment;
}

ScatteringDegree scattering_degree(const PhaseFunction& phase, const DirectionSet& set) {
  if (largest_beyond(phase, 0) == 0) return {0, "isotropic"};
  int degree = 1;
  while (degree < highest_degree && !is_negligible_beyond(phase, degree)) ++degree;
  const int resolved = DiscreteHarmonics(set, degree).full_degree();
  const char* why = resolved < degree                     ? "all that the direction set resolves"
                    : is_negligible_beyond(phase, degree) ? "what is beyond is below 0.02"
                                                          : "the highest used";
  degree = std::min(degree, resolved);
  return {degree, reason_text(why, degree, phase_moment(phase, degree + 1))};
}

ScatteringDegree given_degree(int degree, const PhaseFunction& phase, const DirectionSet& set) {
  const int resolved = DiscreteHarmonics(set, degree).full_degree();
  const char* why = resolved < degree ? "all that the direction set resolves" : "as given";
  degree = std::min(degree, resolved);
  return {degree, reason_text(why, degree, phase_moment(phase, degree + 1))};
}

ScatteringAccuracy scattering_accuracy(const PhaseFunction& phase, int degree, const DirectionSet& set,
                                       double forward) {
  const DiscreteHarmonics harmonics(set, degree);
  const auto count = static_cast<std::size_t>(harmonics.count());
  std::vector<double> moment(count);
  for (std::size_t k = 0; k < count; ++k)
    moment[k] = reduced_moment(phase, harmonics.degree_of(static_cast<int>(k)), forward);
  ScatteringAccuracy accuracy;
  double all = 0, negative = 0, cosines = 0;
  const int step = std::max(1, set.count() / most_looked_at);
  int looked_at = 0;
  for (int m = 0; m < set.count(); m += step, ++looked_at) {
    const std::span<const double> from = harmonics.of(OrdinateIndex(m));
    double sum = 0, cosine = 0;
    for (int n = 0; n < set.count(); ++n) {
      const std::span<const double> into = harmonics.of(OrdinateIndex(n));
      double value = 0;
      for (std::size_t k = 0; k < count; ++k) value += moment[k] * from[k] * into[k];
      const double part = set.weight(OrdinateIndex(n)) * value / full_range(set.space());
      sum += part;
      cosine += part * set.direction(OrdinateIndex(m)).dot(set.direction(OrdinateIndex(n)));
      all += std::abs(part);
      negative += std::max(0.0, -part);
      accuracy.smallest = std::min(accuracy.smallest, value);
    }
    accuracy.energy_error = std::max(accuracy.energy_error, std::abs(sum - 1));
    cosines += cosine;
  }
  accuracy.asymmetry = forward + (1 - forward) * cosines / looked_at;
  accuracy.negative_share = negative / all;
  return accuracy;
}

}  // namespace etendue
