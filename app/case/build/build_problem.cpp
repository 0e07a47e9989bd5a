// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/build/build.h"
#include "app/case/build/build_lights.h"
#include "app/case/build/entry_of.h"
#include "app/case/build/field_uses.h"
#include "app/case/build/mesh_names.h"
#include "app/case/build/temperature_range.h"
#include "app/case/temperatures.h"
#include "app/case/values/band_values.h"
#include "app/case/values/medium_coefficients.h"
#include "app/case/values/value_algebra.h"
#include "base/parallel/require_threads.h"
#include "base/parallel/thread_count.h"
#include "solver/angular/kernels/kernel_coefficient.h"

#include <fmt/format.h>

#include "solver/angular/kernels/directional_kernel.h"
#include "solver/angular/kernels/kernel_places.h"
#include "solver/angular/refraction/refraction_weights.h"
#include "solver/materials/phase/phase_mixing.h"

namespace etendue {
namespace {

std::vector<double> region_volumes(const TetrahedralMesh& mesh) {
  std::vector<double> volumes(mesh.region_names().size());
  for (int c = 0; c < mesh.cell_count(); ++c)
    volumes[static_cast<std::size_t>(mesh.region(CellIndex(c)))] += mesh.volume(CellIndex(c));
  return volumes;
}

std::optional<AngularFormula> by_direction(const Value& value) {
  const auto* formula = std::get_if<Formula>(&value);
  if (formula == nullptr || !depends_on_direction(*formula)) return std::nullopt;
  return AngularFormula(*formula);
}

// A formula that depends on the direction stands beside its mean.
void add_absorption(Medium& medium, const Value& value, AngularSpace space) {
  medium.absorption_by_direction.push_back(by_direction(value));
  medium.absorption.push_back(
      medium.absorption_by_direction.back()
          ? coefficient_of(mean_over_directions(std::get<Formula>(value), space == AngularSpace::plane))
          : coefficient_of(value));
}

// Emission that depends on the direction stands beside an isotropic one of 0.
void add_emission(Medium& medium, const Value& value) {
  medium.emission_by_direction.push_back(by_direction(value));
  medium.emission.push_back(medium.emission_by_direction.back() ? Coefficient(0.0) : coefficient_of(value));
}

// Cells emit their mean absorption times it: a medium as warm as its walls is in balance in every cell.
void add_blackbody(Medium& medium, const Value& value) {
  medium.emission.emplace_back(0.0);
  medium.blackbody.push_back(coefficient_of(value));
}

/// Light of another direction set is handed on by its moments: scattering that may choose takes these.
void scatter_by_moments(Medium& medium, int bands) {
  medium.choice.resize(static_cast<std::size_t>(bands));
  for (ScatteringChoice& choice : medium.choice)
    if (choice.backend == ScatteringBackend::automatic) choice.backend = ScatteringBackend::moments;
}

/// A gray medium in radiative equilibrium sends out what it absorbs, 4 pi kappa I_b = kappa G + heat source:
/// it scatters that part isotropically, and its emission is the heat source over 4 pi (Modest, Radiative Heat
/// Transfer, section 14.3).
void reradiate(Medium& medium, const MatterValues& values) {
  medium.reradiation = {medium.absorption.front()};
  medium.absorption = {0.0};
  medium.scattering = {coefficient_of(sum(values.absorption, values.scattering))};
  if (!is_number(values.absorption) || !is_number(values.scattering)) return;  // both parts are isotropic
  const double absorption = std::get<double>(values.absorption);
  medium.phase.front() = with_isotropic_part(medium.phase.front(),
                                             absorption / (absorption + std::get<double>(values.scattering)));
}

Medium medium_of(const MediumCase& entry, const std::string& region, double volume, int bands) {
  Medium medium;
  medium.name = region;
  medium.origin = entry.origin;
  medium.uncollided = entry.uncollided;
  medium.choice = entry.choice;
  medium.directional = entry.directional;
  for (int band = 0; band < bands; ++band) {
    const MatterValues matter = matter_values(entry, band);
    add_absorption(medium, matter.absorption, entry.space);
    medium.scattering.push_back(coefficient_of(matter.scattering));
    // q = P / (4 pi V), in the plane P / (2 pi V), with the volume that is meshed, so that the power comes
    // out whatever the facets.
    if (entry.power)
      medium.emission.emplace_back(std::get<double>(value_of(*entry.power, band)) /
                                   (full_range(entry.space) * volume));
    else if (entry.blackbody)
      add_blackbody(medium, value_of(*entry.blackbody, band));
    else
      add_emission(medium, emission_value(entry, band));
    const bool common = entry.phase.size() == 1;
    medium.phase.push_back(entry.phase.empty() ? PhaseFunction{}
                                               : entry.phase[common ? 0 : static_cast<std::size_t>(band)]);
  }
  if (entry.reradiates) reradiate(medium, matter_values(entry, 0));
  return medium;
}

[[noreturn]] void fail_kernel(const Origin& medium, const InputError& error) {
  Origin origin = medium;
  origin.key += ".kernel";
  throw InputError(fault_at(origin, "", error.faults().front().text));
}

bool differs_by_cell(const DirectionalScattering& kernel, const TetrahedralMesh& mesh, int region) {
  const auto* formula = std::get_if<KernelFormula>(&kernel);
  return formula != nullptr && !kernel_places(*formula, mesh, region).empty();
}

/// A kernel's scattering follows from its formula or matrix, and its absorption from what is given beside it.
void add_kernel(Medium& medium, const BandValues& extinctions, const DirectionSet& directions,
                const TetrahedralMesh& mesh, int region) {
  medium.extinction_by_direction = !extinctions.values.empty();
  try {
    for (std::size_t band = 0; band < medium.directional.size(); ++band) {
      medium.scattering[band] = kernel_scattering(medium.directional[band], directions, mesh, region);
      if (medium.extinction_by_direction && differs_by_cell(medium.directional[band], mesh, region))
        throw InputError(
            "the kernel depends on the place and extinction is given beside it; give absorption instead");
      // A kernel that makes light, or is negative, is refused with the direction, before means hide it.
      if (band == 0 || medium.directional[band] != medium.directional[band - 1])
        directional_kernel(medium.directional[band], directions);
      if (const auto extinction = kernel_extinction(medium.directional[band]))
        medium.absorption[band] = *extinction - medium.scattering[band].at(Vec3::Zero());
      if (!medium.extinction_by_direction) continue;
      const Value& given = value_of(extinctions, static_cast<int>(band));
      const double* number = std::get_if<double>(&given);
      const Formula extinction =
          number != nullptr ? Formula(fmt::format("{:.17g}", *number)) : std::get<Formula>(given);
      medium.absorption_by_direction[band].emplace(extinction);
      Formula absorption = mean_over_directions(extinction, false);
      absorption.text += fmt::format("-({})", medium.scattering[band].text());
      medium.absorption[band] = coefficient_of(absorption);
    }
  } catch (const InputError& error) {
    fail_kernel(medium.origin, error);
  }
}

bool depends_on_place(const DirectionalScattering& kernel) {
  const auto* formula = std::get_if<KernelFormula>(&kernel);
  return formula != nullptr &&
         (formula->formula->uses("x") || formula->formula->uses("y") || formula->formula->uses("z"));
}

std::vector<double> band_numbers(const BandValues& values, int bands) {
  std::vector<double> numbers;
  for (int band = 0; band < bands; ++band)
    numbers.push_back(values.values.empty() ? 0 : std::get<double>(value_of(values, band)));
  return numbers;
}

Wall wall_of(const WallCase& entry, const std::string& name, int bands) {
  Wall wall{name,
            std::vector<double>(static_cast<std::size_t>(bands), 0),
            band_numbers(entry.diffuse, bands),
            band_numbers(entry.specular, bands),
            entry.origin,
            entry.uncollided};
  wall.refractive_index = entry.refractive_index;
  wall.glossy = entry.glossy;
  if (!entry.transmittance.values.empty()) wall.transmittance = band_numbers(entry.transmittance, bands);
  wall.emission_follows = entry.iterates_temperature();
  if (entry.reradiates) {
    // A gray wall gives back what it absorbs, and its heat flux is the radiance times pi.
    wall.reradiation = {wall.absorptivity(0)};
    wall.diffuse.front() += wall.reradiation.front();
  }
  for (int band = 0; band < bands && !entry.radiance.values.empty(); ++band) {
    const Value& value = value_of(entry.radiance, band);
    wall.radiance_by_direction.emplace_back();
    if (const double* number = std::get_if<double>(&value))
      wall.radiance[static_cast<std::size_t>(band)] = *number;
    else
      wall.radiance_by_direction.back().emplace(std::get<Formula>(value));
  }
  return wall;
}

/// Where media have temperatures, light is not refracted between them.
void check_indices(const Case& input, const TetrahedralMesh& mesh) {
  for (const std::string& name : mesh.region_names())
    if (const MediumCase entry = entry_of(input.media, name);
        has_temperatures(input) && entry.refractive_index != input.bands.refractive_index)
      throw InputError(fault_at(
          entry.origin, "",
          fmt::format(
              "{} has the refractive_index {:g} and another medium {:g}; in a case with temperatures they "
              "must be the same (light is not refracted between media)",
              name, entry.refractive_index, input.bands.refractive_index)));
}

/// A set and the copies of it that the case asks for, each with weights for the walls that refract.
std::vector<DirectionSet> rotated_and_fitted(const DirectionSet& set, const Case& input,
                                             const Problem& problem) {
  const std::vector<SmoothPlane> planes = smooth_planes(problem.mesh(), problem.walls());
  std::vector<DirectionSet> sets;
  for (const DirectionSet& copy : rotated_copies(set, input.rotations, input.direction_seed))
    sets.push_back(fitted_to_refraction(copy, planes));
  return sets;
}

}  // namespace

Problem build_problem(const Case& input, const TetrahedralMesh& mesh) {
  const int threads = thread_count(input.solve.threads);
  require_threads(threads);
  check_names(input, names_of(mesh));
  field_uses(input, mesh);          // all fields cover what they are used in
  molar_ratio_range(input, mesh);   // all are numbers
  temperature_ranges(input, mesh);  // none is negative
  check_indices(input, mesh);
  const int bands = input.bands.count();
  const std::vector<double> volumes = region_volumes(mesh);
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names())
    walls.push_back(wall_of(entry_of(input.walls, name), name, bands));
  std::vector<Medium> media;
  for (std::size_t region = 0; region < volumes.size(); ++region) {
    const std::string& name = mesh.region_names()[region];
    const MediumCase entry = entry_of(input.media, name);
    media.push_back(medium_of(entry, name, volumes[region], bands));
    if (input.first_collided) scatter_by_moments(media.back(), bands);
    if (entry.has_kernel)
      add_kernel(media.back(), entry.kernel_extinction,
                 fitted_to_refraction(build_directions(input), smooth_planes(mesh, walls)), mesh,
                 static_cast<int>(region));
  }
  std::vector<Light> lights = build_lights(input, mesh, walls);
  return Problem(mesh, input.bands, std::move(media), std::move(walls), input.angular_space,
                 std::move(lights), threads);
}

void check_kernels(const Case& input) {
  for (const auto& [name, medium] : input.media) {
    // All bands have the same kernel.
    if (!medium.has_kernel || depends_on_place(medium.directional.front())) continue;
    try {
      directional_kernel(medium.directional.front(), build_directions(input));
    } catch (const InputError& error) {
      fail_kernel(medium.origin, error);
    }
  }
}

DirectionSet build_directions(const Case& input, const Problem& problem) {
  return fitted_to_refraction(build_directions(input), smooth_planes(problem.mesh(), problem.walls()));
}

std::vector<DirectionSet> build_rotated_directions(const Case& input, const Problem& problem) {
  return rotated_and_fitted(build_directions(input), input, problem);
}

std::vector<DirectionSet> build_first_collided_directions(const Case& input, const Problem& problem) {
  if (!input.first_collided) return {};
  const DirectionSet set = make_directions(input.first_collided->set, input.first_collided->order);
  return rotated_and_fitted(input.direction_rotation ? rotated(set, *input.direction_rotation) : set, input,
                            problem);
}

}  // namespace etendue
