// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "solver/angle/harmonics.h"

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

}  // namespace

ScatteringDegree scattering_degree(const PhaseFunction& phase, const DirectionSet& set) {
  // The first moment that a degree leaves out is looked at too.
  std::vector<double> moments;
  for (int l = 0; l <= highest_degree + 1; ++l) moments.push_back(std::abs(phase_moment(phase, l)));
  const auto largest_beyond = [&moments](int degree) {
    return *std::max_element(moments.begin() + degree + 1, moments.end());
  };
  if (largest_beyond(0) == 0) return {0, "isotropic"};
  int degree = 1;
  while (degree < highest_degree && largest_beyond(degree) > negligible_moment) ++degree;
  const int resolved = DiscreteHarmonics(set, degree).full_degree();
  const bool small = largest_beyond(degree) <= negligible_moment;
  const char* why = resolved < degree ? "all that the direction set resolves"
                    : small           ? "what is beyond is below 0.02"
                                      : "the highest used";
  degree = std::min(degree, resolved);
  return {degree, reason_text(why, degree, phase_moment(phase, degree + 1))};
}

ScatteringAccuracy scattering_accuracy(const PhaseFunction& phase, int degree, const DirectionSet& set) {
  const DiscreteHarmonics harmonics(set, degree);
  // Integrals of Y_k and of Y_k times the direction: what the kernel's row sums and mean cosines are made of.
  std::vector<double> integral(static_cast<std::size_t>(harmonics.count()), 0.0);
  std::vector<Vec3> first_moment(integral.size(), Vec3::Zero());
  for (int m = 0; m < set.count(); ++m) {
    const OrdinateIndex ordinate(m);
    for (std::size_t k = 0; k < integral.size(); ++k) {
      const double weighted = set.weight(ordinate) * harmonics.of(ordinate)[k];
      integral[k] += weighted;
      first_moment[k] += weighted * set.direction(ordinate);
    }
  }
  std::vector<double> moment;
  for (int l = 0; l <= degree; ++l) moment.push_back(phase_moment(phase, l));
  ScatteringAccuracy accuracy;
  for (int m = 0; m < set.count(); ++m) {
    const OrdinateIndex ordinate(m);
    double sum = 0, cosine = 0;
    for (std::size_t k = 0; k < integral.size(); ++k) {
      const double factor = moment[static_cast<std::size_t>(harmonics.degree_of(static_cast<int>(k)))] *
                            harmonics.of(ordinate)[k] / full_range(set.space());
      sum += factor * integral[k];
      cosine += factor * first_moment[k].dot(set.direction(ordinate));
    }
    accuracy.energy_error = std::max(accuracy.energy_error, std::abs(sum - 1));
    accuracy.asymmetry += cosine / set.count();
  }
  return accuracy;
}

}  // namespace etendue
