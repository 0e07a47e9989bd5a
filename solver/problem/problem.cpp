// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/problem/problem.h"

#include <stdexcept>
#include <utility>

#include "mesh/tetrahedra/corners.h"
#include "solver/problem/plane_checks.h"
#include "solver/problem/problem_checks.h"

namespace etendue {
namespace {

using CellsByRegion = std::vector<std::vector<CellIndex>>;

CellsByRegion cells_by_region(const TetrahedralMesh& mesh) {
  CellsByRegion cells(mesh.region_names().size());
  for (int c = 0; c < mesh.cell_count(); ++c)
    cells[static_cast<std::size_t>(mesh.region(CellIndex(c)))].push_back(CellIndex(c));
  return cells;
}

/// Lists that are not as long as the mesh and the bands ask are a mistake of the program, not of its user.
void require_sizes(const TetrahedralMesh& mesh, const Bands& bands, const std::vector<Medium>& media,
                   const std::vector<Wall>& walls) {
  const std::size_t n = bands.names.size();
  bool good = media.size() == mesh.region_names().size() && walls.size() == mesh.wall_names().size();
  for (const Medium& medium : media)
    good = good && medium.absorption.size() == n && medium.scattering.size() == n &&
           medium.emission.size() == n && medium.phase.size() == n &&
           (medium.blackbody.empty() || medium.blackbody.size() == n);
  for (const Wall& wall : walls)
    good = good && wall.radiance.size() == n && wall.diffuse.size() == n && wall.specular.size() == n &&
           (wall.glossy.empty() || wall.glossy.size() == n) &&
           (wall.transmittance.empty() || wall.transmittance.size() == n);
  if (!good)
    throw std::invalid_argument("a problem needs a medium per region, a wall per wall, a value per band");
}

/// A list of coefficients of media, and its key in the case.
struct CoefficientKind {
  std::vector<Coefficient> Medium::*list;
  const char* key;
};

/// Cell means, [cell][band]; the first bad cell of each medium and band becomes a fault.
std::vector<double> cell_means(const TetrahedralMesh& mesh, const CellsByRegion& cells, const Bands& bands,
                               const std::vector<Medium>& media, const CoefficientKind& kind,
                               std::vector<Fault>& faults) {
  const std::size_t band_count = bands.names.size();
  std::vector<double> means(static_cast<std::size_t>(mesh.cell_count()) * band_count);
  for (std::size_t region = 0; region < media.size(); ++region)
    for (std::size_t band = 0; band < band_count; ++band) {
      const Coefficient& coefficient = (media[region].*kind.list)[band];
      for (const CellIndex cell : cells[region]) {
        const CellSample sample = coefficient.sample(corners_of(mesh, cell));
        if (!check_sample({origin_of(media[region], kind.key), bands.names[band]}, coefficient, sample,
                          faults))
          break;
        means[cell.at() * band_count + band] = sample.mean;
      }
    }
  return means;
}

}  // namespace

void Problem::find_emission(std::vector<Fault>& faults) {
  emission_ = CellEmission(static_cast<std::size_t>(mesh_.cell_count()), bands_.names.size());
  // What a coefficient emits, `factor` [cell][band] times as much; empty: 1.
  const auto add = [&](const std::vector<Coefficient>& list, std::size_t region, std::size_t band,
                       const std::vector<CellIndex>& cells, const std::vector<double>& factor) {
    if (list.empty()) return;
    for (const CellIndex cell : cells) {
      CellSample sample = list[band].sample(corners_of(mesh_, cell));
      if (!check_sample({origin_of(media_[region], "emission"), bands_.names[band]}, list[band], sample,
                        faults))
        return;
      const double times = factor.empty() ? 1 : factor[cell.at() * bands_.names.size() + band];
      for (double& value : sample.slope) value *= times;
      emission_.add(cell, band, times * sample.mean, sample.slope);
    }
  };
  const CellsByRegion cells = cells_by_region(mesh_);
  for (std::size_t region = 0; region < media_.size(); ++region)
    for (std::size_t band = 0; band < bands_.names.size(); ++band) {
      add(media_[region].emission, region, band, cells[region], {});
      add(media_[region].blackbody, region, band, cells[region], absorption_);
    }
}

Problem::Problem(const TetrahedralMesh& mesh, Bands bands, std::vector<Medium> media, std::vector<Wall> walls,
                 AngularSpace space, std::vector<Light> lights)
    : mesh_(mesh),
      bands_(std::move(bands)),
      media_(std::move(media)),
      walls_(std::move(walls)),
      space_(space),
      lights_(std::move(lights)) {
  require_sizes(mesh_, bands_, media_, walls_);
  if (space_ == AngularSpace::plane)
    for (Medium& medium : media_)
      for (PhaseFunction& phase : medium.phase) phase = in_plane(phase);
  std::vector<Fault> faults;
  const CellsByRegion cells = cells_by_region(mesh_);
  const auto means = [&](const CoefficientKind& kind) {
    return cell_means(mesh_, cells, bands_, media_, kind, faults);
  };
  absorption_ = means({&Medium::absorption, "absorption"});
  scattering_ = means({&Medium::scattering, "scattering"});
  find_emission(faults);
  for (const Medium& medium : media_) check_phase(medium, bands_, faults);
  for (const Wall& wall : walls_) check_wall(wall, bands_, faults);
  check_sheets(*this, faults);
  if (space_ == AngularSpace::plane) check_plane_walls(*this, faults);
  if (faults.empty()) check_steady_state(*this, faults);
  if (!faults.empty()) throw InputError(std::move(faults));
}

}  // namespace etendue
