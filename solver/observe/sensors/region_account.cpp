// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/sensors/region_account.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <span>
#include <vector>

#include "base/field_view.h"
#include "solver/angular/refraction/ordinate_reflectance.h"
#include "solver/observe/radiance/collided_source.h"
#include "solver/transport/source/ordinate_lights.h"

namespace etendue {
namespace {

/// What feeds light: all that there is, or the input of its sweep alone.
enum class FedBy { everything, input };

/// Normals of one flat wall differ by rounding only.
constexpr double same_normal = 1e-9;

/// The radiance that one ordinate brings, at the faces of the mesh.
class Radiance {
 public:
  Radiance(const Problem& problem, const DirectionSet& directions, const Solution& solution, FedBy fed)
      : problem_(problem),
        directions_(directions),
        solution_(solution),
        fed_(fed),
        bands_(solution.fluence.size() / 4 / static_cast<std::size_t>(problem.mesh().cell_count())) {
    find_surfaces();
  }

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
  /// Radiance that a wall sends in: emission, light reflected diffusely, and that of the mirrored ordinate;
  /// and what an angular input adds [3][band].
  double from_wall(OrdinateIndex n, FaceIndex face, std::size_t band, std::span<const double> added) const {
    const Wall& wall = problem_.wall(problem_.mesh().wall(face));
    const Vec3 normal = problem_.mesh().area_normal(face).normalized();
    double irradiance = 0, emitted = wall.radiance[band], mirrored = wall.specular[band], sent = 0;
    if (const double index = wall.refractive_index; index != 1) {
      mirrored = surface(wall, normal)->reflected[n.at()];
      emitted *= index * index * (1 - mirrored);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      irradiance += ConstFaceField(solution_.irradiance, bands_)(face, i, band) / 3;
      sent += added[i * bands_ + band] / 3;
    }
    if (fed_ == FedBy::everything)
      sent += emitted + problem_.following_radiance(face, static_cast<int>(band));
    if (fed_ == FedBy::everything && wall.diffuse[band] > 0)
      sent += wall.diffuse[band] * irradiance / solution_.half_range[face.at()];
    if (mirrored > 0)
      sent += mirrored * on_face(OrdinateIndex(directions_.mirrored(n, normal)), face,
                                 problem_.mesh().owner(face), band);
    return sent;
  }

 private:
  /// A flat surface that refracts.
  struct Surface {
    const Wall* wall;
    Vec3 normal;
    std::vector<double> reflected;  ///< [ordinate]
  };

  void find_surfaces() {
    const TetrahedralMesh& mesh = problem_.mesh();
    for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
      const Wall& wall = problem_.wall(mesh.wall(FaceIndex(f)));
      if (wall.refractive_index == 1) continue;
      const Vec3 normal = mesh.area_normal(FaceIndex(f)).normalized();
      if (surface(wall, normal) == surfaces_.end())
        surfaces_.push_back({&wall, normal, ordinate_reflectances(directions_, wall, normal)});
    }
  }
  std::vector<Surface>::const_iterator surface(const Wall& wall, const Vec3& normal) const {
    return std::ranges::find_if(surfaces_, [&](const Surface& s) {
      return s.wall == &wall && (s.normal - normal).norm() < same_normal;
    });
  }
  double value(OrdinateIndex n, CellIndex cell, std::size_t node, std::size_t band) const {
    return ConstCellField(solution_.radiance[n.at()].values, bands_)(cell, node, band);
  }
  const Problem& problem_;
  const DirectionSet& directions_;
  const Solution& solution_;
  FedBy fed_;
  std::size_t bands_;
  std::vector<Surface> surfaces_;
};

/// Groups that are evaluated together.
struct Ordinate {
  OrdinateIndex number;
  Vec3 travel;
  double weight;
};

void add_flow(const Radiance& radiance, const SurfaceFace& part, const Ordinate& n,
              std::initializer_list<const AngularInput*> inputs, RegionAccount& account) {
  const double across = part.area.dot(n.travel);
  if (across == 0) return;
  std::vector<double> added(3 * radiance.bands(), 0);
  for (const AngularInput* input : inputs)
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

double cell_mean(std::span<const double> values, std::size_t band, std::size_t bands) {
  return (values[band] + values[bands + band] + values[2 * bands + band] + values[3 * bands + band]) / 4;
}

/// The account of one solution and its ordinates.
class Bookkeeping {
 public:
  /// `sources` tells extinction, and what is scattered where everything feeds the light.
  Bookkeeping(const Problem& problem, const CollidedSource& sources, const DirectionSetSolution& swept,
              const AccountScope& scope, FedBy fed)
      : problem_(problem),
        sources_(sources),
        swept_(swept),
        scope_(scope),
        fed_(fed),
        radiance_(problem, swept.directions, swept.solution, fed),
        lights_(problem, swept.directions, nullptr),
        source_(4 * radiance_.bands()),
        added_(source_),
        shining_(source_) {
    for (std::int32_t c = 0; c < problem.mesh().cell_count(); ++c)
      if (problem.mesh().region(CellIndex(c)) == scope.region) cells_.emplace_back(c);
  }

  RegionAccount account() {
    RegionAccount account(radiance_.bands());
    for (int m = 0; m < swept_.directions.count(); ++m) {
      const OrdinateIndex number(m);
      const Ordinate n{number, swept_.directions.direction(number), swept_.directions.weight(number)};
      if (scope_.cone && !scope_.cone->holds(n.travel)) continue;
      account.solid_angle += n.weight;
      for (const SurfaceFace& part : scope_.surface)
        add_flow(radiance_, part, n, {swept_.input, fed_ == FedBy::everything ? &lights_ : nullptr}, account);
      const CollidedSource::View view = sources_.view(n.travel);
      for (const CellIndex cell : cells_) add_cell(cell, n, view, account);
    }
    return account;
  }

 private:
  /// Writes what is scattered in and emitted at the vertices, [4][band].
  void find_sources(CellIndex cell, const Ordinate& n, const CollidedSource::View& view) {
    std::fill(source_.begin(), source_.end(), 0.0);
    std::fill(added_.begin(), added_.end(), 0.0);
    if (fed_ == FedBy::everything) sources_.values(cell, view, source_);
    if (swept_.input != nullptr) {
      swept_.input->add_source(n.number, cell, added_);
      swept_.input->add_projected_source(n.number, cell, added_);
    }
    std::fill(shining_.begin(), shining_.end(), 0.0);
    if (fed_ == FedBy::everything) lights_.add_source(n.number, cell, shining_);
  }
  void add_cell(CellIndex cell, const Ordinate& n, const CollidedSource::View& view, RegionAccount& account) {
    find_sources(cell, n, view);
    const double phase_volume = n.weight * problem_.mesh().volume(cell);
    for (std::size_t b = 0; b < radiance_.bands(); ++b) {
      const double path = phase_volume * radiance_.mean(n.number, cell, b);
      const double absorption = problem_.absorption(cell, static_cast<int>(b));
      const double emitted =
          fed_ == FedBy::everything ? phase_volume * problem_.emission(cell, static_cast<int>(b)) : 0;
      account.path[b] += path;
      account.absorbed[b] += absorption * path;
      account.scattered_out[b] += (sources_.extinction(cell, b, view) - absorption) * path;
      account.emitted[b] += emitted + phase_volume * cell_mean(shining_, b, radiance_.bands());
      account.scattered_in[b] += phase_volume * (cell_mean(source_, b, radiance_.bands()) +
                                                 cell_mean(added_, b, radiance_.bands())) -
                                 emitted;
    }
  }

  const Problem& problem_;
  const CollidedSource& sources_;
  const DirectionSetSolution& swept_;
  const AccountScope& scope_;
  FedBy fed_;
  Radiance radiance_;
  OrdinateLights lights_;
  std::vector<CellIndex> cells_;
  std::vector<double> source_, added_, shining_;  ///< [4][band] of CollidedSource, the input, lights
};

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

AccountScope region_scope(const TetrahedralMesh& mesh, int region, const std::optional<Cone>& cone) {
  return {region, surface_of(mesh, region), cone};
}

RegionAccount region_account(const LightSetup& lights, const SolveOptions& options,
                             const DirectionSetSolution& swept, const AccountScope& scope) {
  const Problem problem = lights.remaining();
  const CollidedSource sources(lights, swept.directions, options, swept.solution.state);
  RegionAccount account = Bookkeeping(problem, sources, swept, scope, FedBy::everything).account();
  if (swept.first_collided == nullptr) return account;
  const double solid_angle = account.solid_angle;
  account.add(Bookkeeping(problem, sources, *swept.first_collided, scope, FedBy::input).account(), 1);
  account.solid_angle = solid_angle;
  return account;
}

}  // namespace etendue
