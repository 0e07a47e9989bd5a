// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/photons/sampling/directional_medium.h"

#include <algorithm>

#include "solver/angular/media/directional_absorption.h"
#include "solver/angular/sets/direction_set.h"
#include "solver/photons/kernel/photon_scene.h"
#include "solver/problem/problem_checks.h"

namespace etendue {
namespace {

bool depends_on_direction(const Medium& medium, int band) {
  return medium.is_directional(band) || medium.absorbs_by_direction(band);
}

std::unique_ptr<DirectionSampler> sampler_of(const Problem& problem, int region, int band) {
  const Medium& medium = problem.medium(region);
  if (!medium.is_directional(band)) return nullptr;
  const DirectionalScattering& scattering = medium.directional[static_cast<std::size_t>(band)];
  const auto* kernel = std::get_if<KernelFormula>(&scattering);
  if (kernel == nullptr) return make_direction_sampler(scattering);
  try {
    return std::make_unique<KernelSampler>(*kernel, problem.mesh(), region);
  } catch (const InputError& error) {
    throw InputError(fault_at(origin_of(medium, "kernel"), "", error.faults().front().text));
  }
}

/// Looks at absorption by a formula in some directions.
void check_absorption(const Problem& problem, const RayMatter& matter, int region, int band) {
  const DirectionSet looked_at =
      problem.space() == AngularSpace::plane ? directions_flatland(96) : directions_ldfe_sq(1);
  std::vector<CellIndex> cells;
  std::vector<double> scattering;
  for (std::int32_t c = 0; c < problem.mesh().cell_count(); ++c)
    if (problem.mesh().region(CellIndex(c)) == region) {
      cells.emplace_back(c);
      scattering.push_back(problem.scattering(CellIndex(c), band));
    }
  if (cells.empty()) return;
  const auto scatters = std::ranges::max_element(scattering) - scattering.begin();
  const auto at = static_cast<std::size_t>(scatters);
  DenseKernel kernel;
  for (const Vec3& travel : looked_at.directions()) {
    const double there = matter.along(cells[at], static_cast<std::size_t>(band), travel).scattering;
    kernel.total.push_back(scattering[at] > 0 ? there / scattering[at] : 0);
  }
  directional_absorption(problem, looked_at, problem.medium(region), band, kernel, cells, scattering);
}

}  // namespace

DirectionalMedia::DirectionalMedia(const Problem& problem) : bands_(problem.band_count()) {
  if (!depends_on_direction(problem)) return;
  matter_ = std::make_unique<const RayMatter>(problem);
  for (int region = 0; region < static_cast<int>(problem.media().size()); ++region)
    for (int band = 0; band < bands_; ++band) {
      const Medium& medium = problem.medium(region);
      media_.emplace_back();
      if (!depends_on_direction(medium, band)) continue;
      if (medium.absorbs_by_direction(band)) check_absorption(problem, *matter_, region, band);
      media_.back() = std::make_unique<const DirectionalMedium>(problem, *matter_, region, band,
                                                                sampler_of(problem, region, band));
      if (const auto* kernel = dynamic_cast<const KernelSampler*>(media_.back()->sampler()))
        kernels_.push_back(kernel);
    }
}

std::pair<std::int64_t, std::int64_t> DirectionalMedia::beyond_bounds() const {
  std::int64_t beyond = 0, draws = 0;
  for (const KernelSampler* kernel : kernels_) {
    beyond += kernel->beyond_bound().first;
    draws += kernel->beyond_bound().second;
  }
  return {beyond, draws};
}

DirectionalMedium::DirectionalMedium(const Problem& problem, const RayMatter& matter, int region, int band,
                                     std::unique_ptr<DirectionSampler> sampler)
    : problem_(problem),
      matter_(matter),
      band_(static_cast<std::size_t>(band)),
      absorbs_by_direction_(problem.medium(region).absorbs_by_direction(band)),
      sampler_(std::move(sampler)),
      meeting_rate_(sampler_ ? sampler_->meeting_rate() : 0) {}

bool is_reciprocal(const Problem& problem) {
  for (const Medium& medium : problem.media())
    for (const DirectionalScattering& scattering : medium.directional)
      if (const auto* kernel = std::get_if<KernelFormula>(&scattering); kernel && !kernel->reciprocal)
        return false;
  return true;
}

bool depends_on_direction(const Problem& problem) {
  for (const Medium& medium : problem.media())
    for (int band = 0; band < problem.band_count(); ++band)
      if (depends_on_direction(medium, band)) return true;
  return false;
}

DirectedCoefficients coefficients_along(const DirectionalMedium& medium, std::int32_t cell,
                                        const double (&w)[3], double sense) {
  const PathCoefficients found = medium.coefficients(CellIndex(cell), sense * Vec3(w[0], w[1], w[2]));
  return {found.absorption, found.scattering};
}

void scatter_by_direction(const DirectionalMedium& medium, std::int32_t cell, RandomStream& stream,
                          double (&w)[3]) {
  DrawnNumbers random(stream);
  const Vec3 scattered = medium.sampler()->scattered(CellIndex(cell), {w[0], w[1], w[2]}, random);
  for (int axis = 0; axis < 3; ++axis) w[axis] = scattered[axis];
}

}  // namespace etendue
