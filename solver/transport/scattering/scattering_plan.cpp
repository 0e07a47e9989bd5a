// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/scattering/scattering_plan.h"

#include <fmt/format.h>

#include "solver/angular/harmonics/harmonics.h"
#include "solver/angular/kernels/kernel_places.h"
#include "solver/transport/kernel/sweep_kernel.h"

namespace etendue {
namespace {

ScatteringTreatment treatment_by_moments(const ScatteringChoice& choice, const PhaseFunction& phase,
                                         const DirectionSet& directions) {
  const ScatteringDegree degree = choice.degree < 0 ? scattering_degree(phase, directions)
                                                    : given_degree(choice.degree, phase, directions);
  ScatteringTreatment treatment{ScatteringBackend::moments, degree.degree, 0, degree.reason};
  const double left_out = phase_moment(phase, degree.degree + 1);
  const bool wanted =
      choice.peak == ForwardPeak::delta_m || (choice.peak == ForwardPeak::automatic && choice.degree < 0 &&
                                              left_out > 0 && !is_negligible_beyond(phase, degree.degree));
  if (wanted && left_out != 0) {
    treatment.forward = left_out;
    treatment.reason +=
        fmt::format("; delta-M: {:.3g} of the scattered light goes on straight ahead", left_out);
  }
  return treatment;
}

constexpr double mebibyte = 1024 * 1024;

std::string memory_text(double bytes) {
  return fmt::format("{:.3g} MiB for the angular solution", bytes / mebibyte);
}

/// What kernels that differ from cell to cell cost.
std::string places_text(const Problem& problem, const DirectionSet& directions, int region, int band) {
  const std::size_t places = kernel_places(problem, region, band).size();
  return places == 0 ? ""
                     : fmt::format(", {:.3g} MiB for the matrices of {} places",
                                   static_cast<double>(places) * matrix_bytes(directions) / mebibyte, places);
}

ScatteringTreatment treat(const ScatteringChoice& choice, const PhaseFunction& phase,
                          const DirectionSet& directions, double bytes) {
  const std::string memory = memory_text(bytes);
  if (choice.backend == ScatteringBackend::dense || choice.backend == ScatteringBackend::galerkin)
    return {choice.backend, 0, 0, "as given; " + memory};
  ScatteringTreatment moments = treatment_by_moments(choice, phase, directions);
  if (choice.backend == ScatteringBackend::moments || choice.degree >= 0 ||
      is_negligible_beyond(phase, moments.degree))
    return moments;
  if (bytes <= largest_automatic_dense)
    return {ScatteringBackend::dense, 0, 0,
            fmt::format("moments of degree {} would leave {:.2g} out; {}", moments.degree,
                        phase_moment(phase, moments.degree + 1), memory)};
  moments.reason += fmt::format("; a matrix would need {}", memory);
  return moments;
}

}  // namespace

double matrix_bytes(const DirectionSet& directions) {
  return 2.0 * sizeof(double) * directions.count() * directions.count();
}

std::vector<double> angular_bytes(const Problem& problem, const DirectionSet& directions) {
  std::vector<double> bytes(problem.media().size(), 0);
  const double of_cell = static_cast<double>(sizeof(double)) * directions.count() *
                         nodes_per_cell(Basis::linear) * lane_stride(problem.band_count());
  for (std::int32_t c = 0; c < problem.mesh().cell_count(); ++c)
    bytes[static_cast<std::size_t>(problem.mesh().region(CellIndex(c)))] += of_cell;
  return bytes;
}

std::vector<ScatteringTreatment> plan_scattering(const Problem& problem, const DirectionSet& directions) {
  const std::vector<double> bytes = angular_bytes(problem, directions);
  std::vector<ScatteringTreatment> plan;
  for (std::size_t region = 0; region < problem.media().size(); ++region) {
    const Medium& medium = problem.media()[region];
    for (int band = 0; band < problem.band_count(); ++band) {
      const PhaseFunction& phase = medium.phase[static_cast<std::size_t>(band)];
      const Coefficient& scattering = medium.scattering[static_cast<std::size_t>(band)];
      if (medium.is_directional(band))
        plan.push_back(
            {ScatteringBackend::dense, 0, 0,
             fmt::format("it depends on the directions themselves; {}{}", memory_text(bytes[region]),
                         places_text(problem, directions, static_cast<int>(region), band))});
      else if (medium.absorbs_by_direction(band))
        plan.push_back(
            {medium.choice_of(band).backend == ScatteringBackend::galerkin ? ScatteringBackend::galerkin
                                                                           : ScatteringBackend::dense,
             0, 0, fmt::format("absorption depends on the direction; {}", memory_text(bytes[region]))});
      else if (scattering.is_constant() && scattering.at(Vec3::Zero()) == 0)
        plan.push_back({ScatteringBackend::moments, 0, 0, "nothing scatters"});
      else
        plan.push_back(treat(medium.choice_of(band), phase, directions, bytes[region]));
    }
  }
  return plan;
}

std::vector<ScatteringTreatment> scattering_on_fewer(const Problem& problem, const DirectionSet& directions,
                                                     const std::vector<ScatteringTreatment>& fine) {
  const int resolved = DiscreteHarmonics(directions, highest_degree(fine)).full_degree();
  const auto bands = static_cast<std::size_t>(problem.band_count());
  std::vector<ScatteringTreatment> plan = fine;
  for (std::size_t i = 0; i < plan.size(); ++i) {
    if (plan[i].degree <= resolved) continue;
    plan[i].degree = resolved;
    plan[i].forward = std::max(0.0, phase_moment(problem.media()[i / bands].phase[i % bands], resolved + 1));
  }
  return plan;
}

int highest_degree(const std::vector<ScatteringTreatment>& plan) {
  int degree = 0;
  for (const ScatteringTreatment& treatment : plan) degree = std::max(degree, treatment.degree);
  return degree;
}

std::vector<CellIndex> dense_cells(const Problem& problem, const std::vector<ScatteringTreatment>& plan) {
  std::vector<CellIndex> cells;
  const int bands = problem.band_count();
  for (std::int32_t c = 0; c < problem.mesh().cell_count(); ++c)
    for (int band = 0; band < bands; ++band)
      if (plan[static_cast<std::size_t>(problem.mesh().region(CellIndex(c)) * bands + band)].is_dense()) {
        cells.emplace_back(c);
        break;
      }
  return cells;
}

}  // namespace etendue
