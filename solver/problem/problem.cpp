// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/problem/problem.h"

#include <algorithm>
#include <array>
#include <span>
#include <stdexcept>
#include <utility>

#include "base/parallel/parallel_for.h"
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

/// Samples the coefficients of media in their cells. The first bad cell of each medium and band becomes a
/// fault.
class CellSampler {
 public:
  /// The problem's mesh, bands and media must be there.
  CellSampler(const Problem& problem, int threads, std::vector<Fault>& faults)
      : problem_(problem), threads_(threads), cells_(cells_by_region(problem.mesh())), faults_(faults) {}

  /// Calls take(cell, band, sample) in the cells of media that have such a list.
  template <class Take>
  void sample(const CoefficientKind& kind, const Take& take) const {
    for (std::size_t region = 0; region < cells_.size(); ++region) {
      const Medium& medium = problem_.media()[region];
      const std::vector<Coefficient>& list = medium.*kind.list;
      for (std::size_t band = 0; band < list.size(); ++band)
        sample_band({origin_of(medium, kind.key), problem_.bands().names[band]}, list[band], cells_[region],
                    [&](CellIndex cell, const CellSample& found) { take(cell, band, found); });
    }
  }

  /// [cell][band]
  std::vector<double> means(const CoefficientKind& kind) const {
    const auto bands = static_cast<std::size_t>(problem_.band_count());
    std::vector<double> means(static_cast<std::size_t>(problem_.mesh().cell_count()) * bands);
    sample(kind, [&](CellIndex cell, std::size_t band, const CellSample& found) {
      means[cell.at() * bands + band] = found.mean;
    });
    return means;
  }

 private:
  template <class Take>
  void sample_band(const CoefficientPlace& place, const Coefficient& coefficient,
                   std::span<const CellIndex> cells, const Take& take) const {
    std::vector<CellSample> found;
    for (std::size_t first = 0; first < cells.size(); first += block) {
      const std::span<const CellIndex> some = cells.subspan(first, std::min(block, cells.size() - first));
      found.resize(some.size());
      sample_cells(coefficient, some, found);
      for (std::size_t i = 0; i < some.size(); ++i) {
        if (!check_sample(place, coefficient, found[i], faults_)) return;
        take(some[i], found[i]);
      }
    }
  }

  /// Each thread has the coefficient for itself.
  void sample_cells(const Coefficient& coefficient, std::span<const CellIndex> cells,
                    std::span<CellSample> found) const {
    parallel_for(
        cells.size(), coefficient.is_constant() ? 1 : threads_, 64, [&] { return coefficient; },
        [&](std::size_t i, const Coefficient& own) {
          found[i] = own.sample(corners_of(problem_.mesh(), cells[i]));
          return true;
        });
  }

  static constexpr std::size_t block = 16384;  ///< cells whose samples are held at a time

  const Problem& problem_;
  int threads_;
  CellsByRegion cells_;
  std::vector<Fault>& faults_;
};

/// Of `emission`, and of `blackbody` times the mean absorption [cell][band].
CellEmission emission_of(const CellSampler& sampler, std::span<const double> absorption, std::size_t bands) {
  CellEmission emission(absorption.size() / bands, bands);
  sampler.sample({&Medium::emission, "emission"},
                 [&](CellIndex cell, std::size_t band, const CellSample& found) {
                   emission.add(cell, band, found.mean, found.slope);
                 });
  sampler.sample({&Medium::blackbody, "emission"},
                 [&](CellIndex cell, std::size_t band, const CellSample& found) {
                   const double factor = absorption[cell.at() * bands + band];
                   std::array<double, 4> slope = found.slope;
                   for (double& value : slope) value *= factor;
                   emission.add(cell, band, factor * found.mean, slope);
                 });
  return emission;
}

}  // namespace

Problem::Problem(const TetrahedralMesh& mesh, Bands bands, std::vector<Medium> media, std::vector<Wall> walls,
                 AngularSpace space, std::vector<Light> lights, int threads)
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
  const CellSampler sampler(*this, threads, faults);
  absorption_ = sampler.means({&Medium::absorption, "absorption"});
  scattering_ = sampler.means({&Medium::scattering, "scattering"});
  emission_ = emission_of(sampler, absorption_, bands_.names.size());
  for (const Medium& medium : media_) check_phase(medium, bands_, faults);
  for (const Wall& wall : walls_) check_wall(wall, bands_, faults);
  check_sheets(*this, faults);
  if (space_ == AngularSpace::plane) check_plane_walls(*this, faults);
  if (faults.empty()) check_steady_state(*this, faults);
  if (!faults.empty()) throw InputError(std::move(faults));
}

void Problem::set_following(FollowingSources sources) {
  if (own_emission_.empty()) own_emission_ = emission_;
  emission_ = own_emission_;
  if (!sources.cells.empty()) emission_.add(sources.cells);
  following_ = std::move(sources);
}

}  // namespace etendue
