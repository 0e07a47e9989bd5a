// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/sensors/region_account.h"

#include <algorithm>
#include <array>

#include "solver/picture/collided_source.h"

namespace etendue {
namespace {

/// The radiance that one ordinate brings, at the faces of the mesh.
class Radiance {
 public:
  Radiance(const Problem& problem, const DirectionSet& directions, const Solution& solution)
      : problem_(problem),
        directions_(directions),
        solution_(solution),
        bands_(solution.fluence.size() / 4 / static_cast<std::size_t>(problem.mesh().cell_count())) {}

  std::size_t bands() const { return bands_; }
  double mean(OrdinateIndex n, CellIndex cell, std::size_t band) const {
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i) sum += value(n, cell, i, band);
    return sum / 4;
  }
  /// The mean over a face of what a cell at it has there.
  double on_face(OrdinateIndex n, FaceIndex face, CellIndex cell, std::size_t band) const {
    const auto& corners = problem_.mesh().vertices(cell);
    double sum = 0;
    for (const std::int32_t vertex : problem_.mesh().vertices(face))
      sum += value(n, cell, static_cast<std::size_t>(std::ranges::find(corners, vertex) - corners.begin()),
                   band);
    return sum / 3;
  }
  /// What a wall sends in: emission, light reflected diffusely, and that of the mirrored ordinate.
  double from_wall(OrdinateIndex n, FaceIndex face, std::size_t band) const {
    const Wall& wall = problem_.wall(problem_.mesh().wall(face));
    double irradiance = 0;
    for (std::size_t i = 0; i < 3; ++i)
      irradiance += solution_.irradiance[(face.at() * 3 + i) * bands_ + band] / 3;
    double sent = wall.radiance[band];
    if (wall.diffuse[band] > 0) sent += wall.diffuse[band] * irradiance / solution_.half_range[face.at()];
    if (wall.specular[band] > 0)
      sent += wall.specular[band] *
              on_face(OrdinateIndex(directions_.mirrored(n, problem_.mesh().area_normal(face).normalized())),
                      face, problem_.mesh().owner(face), band);
    return sent;
  }

 private:
  double value(OrdinateIndex n, CellIndex cell, std::size_t node, std::size_t band) const {
    return solution_.radiance[n.at()].values[(cell.at() * 4 + node) * bands_ + band];
  }
  const Problem& problem_;
  const DirectionSet& directions_;
  const Solution& solution_;
  std::size_t bands_;
};

/// A face of the region's surface, and on which side the region is.
struct SurfaceFace {
  FaceIndex face;
  CellIndex inside;
  std::optional<CellIndex> outside;  ///< empty: a wall
  Vec3 area;                         ///< out of the region
};

std::vector<SurfaceFace> surface_of(const TetrahedralMesh& mesh, int region) {
  std::vector<SurfaceFace> surface;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const FaceIndex face(f);
    const bool wall = f < mesh.boundary_face_count();
    const bool owned = mesh.region(mesh.owner(face)) == region;
    const bool beyond = !wall && mesh.region(mesh.neighbour(face)) == region;
    if (owned == beyond) continue;
    if (owned)
      surface.push_back({face, mesh.owner(face), wall ? std::nullopt : std::optional(mesh.neighbour(face)),
                         mesh.area_normal(face)});
    else
      surface.push_back({face, mesh.neighbour(face), mesh.owner(face), -mesh.area_normal(face)});
  }
  return surface;
}

void add_flow(const Radiance& radiance, const SurfaceFace& part, OrdinateIndex n, const Vec3& travel,
              double weight, RegionAccount& account) {
  const double across = part.area.dot(travel);
  for (std::size_t b = 0; b < radiance.bands(); ++b) {
    if (across > 0) {
      account.flowing_out[b] += weight * across * radiance.on_face(n, part.face, part.inside, b);
    } else {
      const double u = part.outside ? radiance.on_face(n, part.face, *part.outside, b)
                                    : radiance.from_wall(n, part.face, b);
      account.flowing_in[b] -= weight * across * u;
    }
  }
}

}  // namespace

double RegionAccount::residual(std::size_t band) const {
  const double in = flowing_in[band] + emitted[band] + scattered_in[band];
  const double out = flowing_out[band] + absorbed[band] + scattered_out[band];
  return in > 0 ? (in - out) / in : 0;
}

RegionAccount region_account(const LightSetup& lights, const DirectionSet& directions,
                             const SolveOptions& options, const Solution& solution, int region,
                             const std::optional<Cone>& cone) {
  const Problem& problem = lights.problem();
  const TetrahedralMesh& mesh = problem.mesh();
  const Radiance radiance(problem, directions, solution);
  const CollidedSource sources(lights, directions, options, solution.state);
  const std::size_t bands = radiance.bands();
  const std::vector<double> nothing(bands, 0);
  RegionAccount account{0, nothing, nothing, nothing, nothing, nothing, nothing, nothing};
  const std::vector<SurfaceFace> surface = surface_of(mesh, region);
  std::vector<double> source(4 * bands);
  for (int m = 0; m < directions.count(); ++m) {
    const OrdinateIndex n(m);
    const Vec3& travel = directions.direction(n);
    const double weight = directions.weight(n);
    if (cone && !cone->holds(travel)) continue;
    account.solid_angle += weight;
    for (const SurfaceFace& part : surface) add_flow(radiance, part, n, travel, weight, account);
    const CollidedSource::View view = sources.view(travel);
    for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
      const CellIndex cell(c);
      if (mesh.region(cell) != region) continue;
      sources.at_vertices(cell, view, source);
      for (std::size_t b = 0; b < bands; ++b) {
        const double phase_volume = weight * mesh.volume(cell);
        const double path = phase_volume * radiance.mean(n, cell, b);
        const double absorption = problem.absorption(cell, static_cast<int>(b));
        const double emitted = phase_volume * problem.emission(cell, static_cast<int>(b));
        const double mean =
            (source[b] + source[bands + b] + source[2 * bands + b] + source[3 * bands + b]) / 4;
        account.path[b] += path;
        account.absorbed[b] += absorption * path;
        account.scattered_out[b] += (sources.extinction(cell, b) - absorption) * path;
        account.emitted[b] += emitted;
        account.scattered_in[b] += phase_volume * mean - emitted;
      }
    }
  }
  return account;
}

}  // namespace etendue
