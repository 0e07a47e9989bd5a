// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/heat/heat_balance.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/blackbody.h"
#include "base/errors.h"
#include "base/field_view.h"
#include "mesh/tetrahedra/corners.h"
#include "solver/problem/band_blackbody.h"

namespace etendue {
double absorption_of_all_bands(const Problem& problem, CellIndex cell) {
  double sum = 0;
  for (int band = 0; band < problem.band_count(); ++band) sum += problem.absorption(cell, band);
  return sum;
}

HeatBalance::HeatBalance(const Problem& problem, const HeatProblem& heat, const TemperatureSpace& space)
    : problem_(problem),
      heat_(heat),
      space_(space),
      volumes_(space.size(), 0),
      factors_(heat.media.size(), 1),
      conduction_(problem, heat, space),
      walls_(problem, heat, space) {
  const TetrahedralMesh& mesh = problem.mesh();
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
    for (std::size_t i = 0; i < 4 && space.has(CellIndex(c)); ++i)
      volumes_[static_cast<std::size_t>(space.unknown(CellIndex(c), i))] += mesh.volume(CellIndex(c)) / 4;
  for (const FollowingFace& face : walls_.faces())
    for (const std::size_t unknown : face.unknowns)
      volumes_[unknown] = mesh.volume(mesh.owner(face.face)) / 4;
  find_sources();
}

void HeatBalance::find_sources() {
  const TetrahedralMesh& mesh = problem_.mesh();
  sources_.assign(static_cast<std::size_t>(4 * mesh.cell_count()), 0);
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    if (!space_.has(cell)) continue;
    const HeatMedium& medium = *heat_.media[static_cast<std::size_t>(mesh.region(cell))];
    const CellSample source = medium.source.sample(corners_of(mesh, cell));
    if (!std::isfinite(source.mean) || !(source.smallest >= 0))
      throw InputError(
          fault_at(medium.origin, "heat_source",
                   fmt::format("is {:g} at ({:.6g}, {:.6g}, {:.6g}); use at least 0", source.smallest,
                               source.where.x(), source.where.y(), source.where.z())));
    for (std::size_t i = 0; i < 4; ++i) sources_[4 * cell.at() + i] = source.mean + source.slope[i];
  }
}

void HeatBalance::set_time(double t) {
  for (std::size_t region = 0; region < factors_.size(); ++region)
    if (const auto& medium = heat_.media[region]; medium && medium->in_time.factor)
      factors_[region] = medium->in_time.factor(t);
  walls_.set_time(t);
}

Blackbodies HeatBalance::blackbodies(std::span<const double> temperature) const {
  const auto bands = static_cast<std::size_t>(problem_.band_count());
  Blackbodies result{std::vector<double>(temperature.size() * bands),
                     std::vector<double>(temperature.size() * bands)};
  const double square = std::pow(problem_.bands().refractive_index, 2);
  for (std::size_t i = 0; i < result.radiance.size(); ++i) {
    const int band = static_cast<int>(i % bands);
    const double kelvin = std::abs(temperature[i / bands]);
    result.radiance[i] =
        std::copysign(band_blackbody(problem_.bands(), band, kelvin), temperature[i / bands]);
    result.slope[i] = square * stefan_boltzmann / std::numbers::pi *
                      space_.power_per_value(i / bands, kelvin) *
                      band_share_of_change(problem_.bands(), band, kelvin);
  }
  return result;
}

FollowingSources HeatBalance::sources(const Blackbodies& blackbodies) const {
  return {emission(blackbodies), walls_.radiance(blackbodies)};
}

CellEmission HeatBalance::emission(const Blackbodies& blackbodies) const {
  const TetrahedralMesh& mesh = problem_.mesh();
  const auto bands = static_cast<std::size_t>(problem_.band_count());
  CellEmission emission(static_cast<std::size_t>(mesh.cell_count()), bands);
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    for (std::size_t band = 0; band < bands && space_.has(cell); ++band) {
      std::array<double, 4> values = {};
      double mean = 0;
      for (std::size_t i = 0; i < 4; ++i) {
        const auto unknown = static_cast<std::size_t>(space_.unknown(cell, i));
        values[i] =
            problem_.absorption(cell, static_cast<int>(band)) * blackbodies.radiance[unknown * bands + band];
        mean += values[i] / 4;
      }
      for (double& value : values) value -= mean;
      emission.add(cell, band, mean, values);
    }
  }
  return emission;
}

std::vector<double> HeatBalance::gains(std::span<const double> temperature, const Blackbodies& blackbodies,
                                       const LightAtVertices& light) const {
  const TetrahedralMesh& mesh = problem_.mesh();
  const auto bands = static_cast<std::size_t>(problem_.band_count());
  const ConstCellField fluence(light.fluence, bands);
  std::vector<double> gains(space_.size(), 0);
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    if (!space_.has(cell)) continue;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto unknown = static_cast<std::size_t>(space_.unknown(cell, i));
      double density = factors_[static_cast<std::size_t>(mesh.region(cell))] * sources_[4 * cell.at() + i];
      for (std::size_t band = 0; band < bands; ++band)
        density +=
            problem_.absorption(cell, static_cast<int>(band)) *
            (fluence(cell, i, band) - 4 * std::numbers::pi * blackbodies.radiance[unknown * bands + band]);
      gains[unknown] += mesh.volume(cell) / 4 * density;
    }
  }
  conduction_.add_gains(temperature, gains);
  walls_.add_gains(temperature, blackbodies, light, gains);
  return gains;
}

}  // namespace etendue
