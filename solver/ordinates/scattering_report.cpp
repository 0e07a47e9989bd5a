// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/ordinates/scattering_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "solver/angle/harmonics.h"

namespace etendue {
namespace {

KernelReport of_moments(const PhaseFunction& phase, const ScatteringTreatment& how,
                        const DirectionSet& directions) {
  const ScatteringAccuracy accuracy = scattering_accuracy(phase, how.degree, directions, how.forward);
  KernelReport report;
  report.asymmetry = accuracy.asymmetry;
  report.energy_error = accuracy.energy_error;
  report.backend = fmt::format("moments, degree {} ({})", how.degree, how.reason);
  report.smallest = accuracy.smallest;
  report.negative_share = accuracy.negative_share;
  report.smallest_forward = report.largest_forward = how.forward;
  return report;
}

KernelReport of_matrix(const DenseKernel& kernel, const ScatteringTreatment& how,
                       const DirectionSet& directions) {
  const DenseAccuracy accuracy = dense_accuracy(kernel, directions);
  KernelReport report;
  report.asymmetry = accuracy.asymmetry;
  report.energy_error = accuracy.energy_error;
  report.backend =
      fmt::format("{} ({})", how.backend == ScatteringBackend::galerkin ? "galerkin" : "dense", how.reason);
  report.smallest = std::min(0.0, accuracy.smallest);
  report.negative_share = accuracy.negative_share;
  report.smallest_forward = accuracy.smallest_forward;
  report.largest_forward = accuracy.largest_forward;
  report.momentum_error = accuracy.momentum_error;
  report.reciprocity_error = accuracy.reciprocity_error;
  report.integral_error = kernel.uncertainty;
  return report;
}

}  // namespace

std::vector<KernelReport> report_kernels(const Problem& problem, const DirectionSet& directions,
                                         const std::vector<ScatteringTreatment>& plan,
                                         const std::vector<DenseGroup>& groups) {
  std::vector<KernelReport> reports;
  for (int region = 0; region < static_cast<int>(problem.media().size()); ++region) {
    const Medium& medium = problem.medium(region);
    for (int b = 0; b < problem.band_count(); ++b) {
      const auto band = static_cast<std::size_t>(b);
      if (!medium.is_directional(b) && medium.scattering[band].is_constant() &&
          medium.scattering[band].at(Vec3::Zero()) == 0)
        continue;
      const ScatteringTreatment& how = plan[static_cast<std::size_t>(region * problem.band_count() + b)];
      const auto group = std::find_if(groups.begin(), groups.end(), [&](const DenseGroup& g) {
        return g.region == region && std::count(g.bands.begin(), g.bands.end(), b) > 0;
      });
      KernelReport report = group == groups.end() ? of_moments(medium.phase[band], how, directions)
                                                  : of_matrix(group->kernel(), how, directions);
      report.medium = medium.name;
      report.band = problem.bands().names[band];
      report.phase = medium.is_directional(b) ? directional_name(medium.directional[band])
                                              : phase_name(medium.phase[band]);
      reports.push_back(std::move(report));
    }
  }
  return reports;
}

}  // namespace etendue
