// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/scattering/scattering_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "solver/angular/harmonics/harmonics.h"

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

/// The worst of several matrices; the asymmetry is their mean.
DenseAccuracy worst_of(const std::vector<const DenseGroup*>& groups, const DirectionSet& directions) {
  DenseAccuracy worst = dense_accuracy(groups.front()->kernel(), directions);
  for (std::size_t i = 1; i < groups.size(); ++i) {
    const DenseAccuracy next = dense_accuracy(groups[i]->kernel(), directions);
    worst.asymmetry += next.asymmetry;
    worst.energy_error = std::max(worst.energy_error, next.energy_error);
    worst.momentum_error = std::max(worst.momentum_error, next.momentum_error);
    worst.reciprocity_error = std::max(worst.reciprocity_error, next.reciprocity_error);
    worst.smallest_forward = std::min(worst.smallest_forward, next.smallest_forward);
    worst.largest_forward = std::max(worst.largest_forward, next.largest_forward);
    worst.smallest = std::min(worst.smallest, next.smallest);
    worst.negative_share = std::max(worst.negative_share, next.negative_share);
  }
  worst.asymmetry /= static_cast<double>(groups.size());
  return worst;
}

KernelReport of_matrices(const std::vector<const DenseGroup*>& groups, const ScatteringTreatment& how,
                         const DirectionSet& directions) {
  const DenseAccuracy accuracy = worst_of(groups, directions);
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
  for (const DenseGroup* group : groups)
    report.integral_error = std::max(report.integral_error, group->kernel().uncertainty);
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
      std::vector<const DenseGroup*> matrices;
      for (const DenseGroup& group : groups)
        if (group.region == region && std::ranges::count(group.bands, b) > 0) matrices.push_back(&group);
      KernelReport report = matrices.empty() ? of_moments(medium.phase[band], how, directions)
                                             : of_matrices(matrices, how, directions);
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
