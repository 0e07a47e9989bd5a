// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/sensors/region_account.h"

#include <algorithm>
#include <array>
#include <span>

#include "solver/picture/collided_source.h"
#include "solver/sensors/region_surface.h"

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
  /// What a wall sends in: emission, light reflected diffusely, and that of the mirrored ordinate; and what
  /// an angular input adds [3][band].
  double from_wall(OrdinateIndex n, FaceIndex face, std::size_t band, std::span<const double> added) const {
    const Wall& wall = problem_.wall(problem_.mesh().wall(face));
    double irradiance = 0, sent = wall.radiance[band];
    for (std::size_t i = 0; i < 3; ++i) {
      irradiance += solution_.irradiance[(face.at() * 3 + i) * bands_ + band] / 3;
      sent += added[i * bands_ + band] / 3;
    }
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

/// What is looked at together.
struct Ordinate {
  OrdinateIndex number;
  Vec3 travel;
  double weight;
};

void add_flow(const Radiance& radiance, const SurfaceFace& part, const Ordinate& n, const AngularInput* input,
              RegionAccount& account) {
  const double across = part.area.dot(n.travel);
  std::vector<double> added(3 * radiance.bands(), 0);
  if (across < 0 && !part.outside && input != nullptr) input->add_inflow(n.number, part.face, added);
  for (std::size_t b = 0; b < radiance.bands(); ++b) {
    if (across > 0) {
      account.flowing_out[b] += n.weight * across * radiance.on_face(n.number, part.face, part.inside, b);
    } else {
      const double u = part.outside ? radiance.on_face(n.number, part.face, *part.outside, b)
                                    : radiance.from_wall(n.number, part.face, b, added);
      account.flowing_in[b] -= n.weight * across * u;
    }
  }
}

double mean_of(std::span<const double> values, std::size_t band, std::size_t bands) {
  return (values[band] + values[bands + band] + values[2 * bands + band] + values[3 * bands + band]) / 4;
}

/// A cell's part: `source` and `added` [4][band] are those of CollidedSource and of an angular input.
void add_cell(const Problem& problem, const Radiance& radiance, const CollidedSource& sources,
              const CollidedSource::View& view, CellIndex cell, const Ordinate& n,
              std::span<const double> source, std::span<const double> added, RegionAccount& account) {
  const double phase_volume = n.weight * problem.mesh().volume(cell);
  for (std::size_t b = 0; b < radiance.bands(); ++b) {
    const double path = phase_volume * radiance.mean(n.number, cell, b);
    const double absorption = problem.absorption(cell, static_cast<int>(b));
    const double emitted = phase_volume * problem.emission(cell, static_cast<int>(b));
    account.path[b] += path;
    account.absorbed[b] += absorption * path;
    account.scattered_out[b] += (sources.extinction(cell, b, view) - absorption) * path;
    account.emitted[b] += emitted;
    account.scattered_in[b] +=
        phase_volume * (mean_of(source, b, radiance.bands()) + mean_of(added, b, radiance.bands())) - emitted;
  }
}

}  // namespace

RegionAccount::RegionAccount(std::size_t bands)
    : path(bands, 0),
      flowing_in(path),
      flowing_out(path),
      emitted(path),
      absorbed(path),
      scattered_in(path),
      scattered_out(path) {}

double RegionAccount::coming_in(std::size_t band) const {
  return flowing_in[band] + emitted[band] + scattered_in[band];
}

double RegionAccount::missing(std::size_t band) const {
  return coming_in(band) - flowing_out[band] - absorbed[band] - scattered_out[band];
}

double RegionAccount::residual(std::size_t band) const {
  return coming_in(band) > 0 ? missing(band) / coming_in(band) : 0;
}

void RegionAccount::add(const RegionAccount& other, double factor) {
  solid_angle += factor * other.solid_angle;
  for (std::vector<double> RegionAccount::*part :
       {&RegionAccount::path, &RegionAccount::flowing_in, &RegionAccount::flowing_out,
        &RegionAccount::emitted, &RegionAccount::absorbed, &RegionAccount::scattered_in,
        &RegionAccount::scattered_out})
    for (std::size_t b = 0; b < path.size(); ++b) (this->*part)[b] += factor * (other.*part)[b];
}

RegionAccount region_account(const LightSetup& lights, const DirectionSet& directions,
                             const SolveOptions& options, const Solution& solution, const AngularInput* input,
                             int region, const std::optional<Cone>& cone) {
  const Problem problem = lights.remaining();
  const TetrahedralMesh& mesh = problem.mesh();
  const Radiance radiance(problem, directions, solution);
  const CollidedSource sources(lights, directions, options, solution.state);
  const std::size_t bands = radiance.bands();
  RegionAccount account(bands);
  const std::vector<SurfaceFace> surface = surface_of(mesh, region);
  std::vector<double> source(4 * bands), added(4 * bands);
  for (int m = 0; m < directions.count(); ++m) {
    const Ordinate n{OrdinateIndex(m), directions.direction(OrdinateIndex(m)),
                     directions.weight(OrdinateIndex(m))};
    if (cone && !cone->holds(n.travel)) continue;
    account.solid_angle += n.weight;
    for (const SurfaceFace& part : surface) add_flow(radiance, part, n, input, account);
    const CollidedSource::View view = sources.view(n.travel);
    for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
      const CellIndex cell(c);
      if (mesh.region(cell) != region) continue;
      sources.at_vertices(cell, view, source);
      std::fill(added.begin(), added.end(), 0.0);
      if (input != nullptr) input->add_source(n.number, cell, added);
      add_cell(problem, radiance, sources, view, cell, n, source, added, account);
    }
  }
  return account;
}

}  // namespace etendue
