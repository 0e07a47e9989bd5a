// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/solve/resolution.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "base/order_statistics.h"
#include "solver/materials/phase/half_width.h"
#include "solver/transport/cells/cell_coefficients.h"
#include "solver/transport/scattering/scattering_plan.h"

namespace etendue {
namespace {

bool shines(const Wall& wall) {
  const auto positive = [](double value) { return value > 0; };
  return wall.emission_follows || std::ranges::any_of(wall.radiance, positive) ||
         std::ranges::any_of(wall.radiance_by_direction,
                             [](const auto& formula) { return formula.has_value(); });
}

std::vector<char> walls_that_shine(const Problem& problem) {
  std::vector<char> shine;
  for (const Wall& wall : problem.walls()) shine.push_back(shines(wall));
  for (const Light& light : problem.lights())
    if (const auto* beam = std::get_if<BeamLight>(&light.kind))
      for (const int wall : beam->walls) shine[static_cast<std::size_t>(wall)] = 1;
  return shine;
}

std::set<CellIndex> cells_at_lights(const Problem& problem, const CellLocator& locator) {
  const TetrahedralMesh& mesh = problem.mesh();
  std::set<CellIndex> cells;
  const std::vector<char> shine = walls_that_shine(problem);
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
    if (shine[static_cast<std::size_t>(mesh.wall(FaceIndex(f)))] != 0) cells.insert(mesh.owner(FaceIndex(f)));
  const auto add = [&](const Vec3& point) {
    for (const CellPoint& at : locator.find(point)) cells.insert(at.cell);
  };
  for (const Light& light : problem.lights()) {
    if (const auto* point = std::get_if<PointLight>(&light.kind)) add(point->position);
    if (const auto* surface = std::get_if<SurfaceLight>(&light.kind))
      std::ranges::for_each(surface->triangles, add);
  }
  return cells;
}

/// Extinction less g times scattering, in the band in which that is largest [1/length].
double transport_extinction(const Problem& problem, CellIndex cell) {
  const Medium& medium = problem.medium(problem.mesh().region(cell));
  double largest = 0;
  for (int b = 0; b < problem.band_count(); ++b) {
    const double g =
        medium.is_directional(b) ? 0 : phase_asymmetry(medium.phase[static_cast<std::size_t>(b)]);
    largest = std::max(largest, problem.absorption(cell, b) + (1 - g) * problem.scattering(cell, b));
  }
  return largest;
}

double largest_extinction(const Problem& problem, CellIndex cell) {
  double largest = 0;
  for (int b = 0; b < problem.band_count(); ++b)
    largest = std::max(largest, problem.absorption(cell, b) + problem.scattering(cell, b));
  return largest;
}

long count_thick(const Problem& problem, const DirectionSet& directions) {
  const TetrahedralMesh& mesh = problem.mesh();
  const std::vector<ScatteringTreatment> plan = plan_scattering(problem, directions);
  long count = 0;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
    for (int b = 0; b < problem.band_count(); ++b) {
      const CellIndex cell(c);
      const auto of_plan = static_cast<std::size_t>(mesh.region(cell) * problem.band_count() + b);
      const double extinction =
          problem.absorption(cell, b) + (1 - plan[of_plan].forward) * problem.scattering(cell, b);
      if (extinction * cell_size(mesh.volume(cell)) > lumping_thickness) ++count;
    }
  return count;
}

std::optional<NarrowPhase> narrowest_phase(const Problem& problem) {
  const TetrahedralMesh& mesh = problem.mesh();
  std::vector<char> scatters(problem.media().size() * static_cast<std::size_t>(problem.band_count()), 0);
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
    for (int b = 0; b < problem.band_count(); ++b)
      if (problem.scattering(CellIndex(c), b) > 0)
        scatters[static_cast<std::size_t>(mesh.region(CellIndex(c)) * problem.band_count() + b)] = 1;
  std::optional<NarrowPhase> narrowest;
  for (std::size_t i = 0; i < scatters.size(); ++i) {
    const auto bands = static_cast<std::size_t>(problem.band_count());
    const Medium& medium = problem.media()[i / bands];
    if (scatters[i] == 0 || medium.is_directional(static_cast<int>(i % bands))) continue;
    const double width = half_width(medium.phase[i % bands]);
    if (width < std::numbers::pi / 2 && (!narrowest || width < narrowest->half_width))
      narrowest = {mesh.region_names()[i / bands], width};
  }
  return narrowest;
}

}  // namespace

Resolution resolution_of(const Problem& problem, const DirectionSet& directions, const CellLocator& cells) {
  const TetrahedralMesh& mesh = problem.mesh();
  Resolution found;
  std::vector<double> thickness, at_lights;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const double depth = largest_extinction(problem, CellIndex(c)) * cell_size(mesh.volume(CellIndex(c)));
    if (depth > 0) thickness.push_back(depth);
  }
  for (const CellIndex cell : cells_at_lights(problem, cells))
    at_lights.push_back(transport_extinction(problem, cell) * cell_size(mesh.volume(cell)));
  if (!thickness.empty()) found.largest_thickness = std::ranges::max(thickness);
  found.median_thickness = median(std::move(thickness));
  found.transport_thickness_at_lights = median(std::move(at_lights));
  found.thick_count = count_thick(problem, directions);
  found.pair_count = static_cast<long>(mesh.cell_count()) * problem.band_count();
  if (problem.space() == AngularSpace::sphere) {
    found.direction_spacing = std::sqrt(4 * std::numbers::pi / directions.count());
    found.narrowest = narrowest_phase(problem);
  }
  return found;
}

}  // namespace etendue
