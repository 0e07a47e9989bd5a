// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/photon_map/map_radiance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mesh/tetrahedra/barycentric.h"
#include "mesh/tetrahedra/sheet_faces.h"
#include "solver/observe/radiance/lit_triangle.h"
#include "solver/problem/lights/light.h"
#include "solver/problem/mirror.h"

namespace etendue {
namespace {

// A ray ends where less of its light is left: an estimate from 100 hits is known to a tenth.
constexpr double faint_estimate = 1e-4;
constexpr int most_estimate_mirrors = 1000;
// Steps along a ray, in radii of the ball at the last one: balls of neighbouring estimates overlap.
// And the fewest and most steps through the medium of one region.
constexpr double step_in_radii = 1;
constexpr double fewest_ball_steps = 4, most_ball_steps = 200;

Vec3 direction_of(const PhotonHit& hit) { return {hit.direction[0], hit.direction[1], hit.direction[2]}; }

/// Shares of hits in an estimate.
struct Sum {
  double first = 0, squares = 0;
  void add(double share) {
    first += share;
    squares += share * share;
  }
  Estimate times(double factor) const { return {factor * first, factor * std::sqrt(squares)}; }
};

}  // namespace

/// Straight segment of a ray between mirrors.
struct MapRadiance::RaySegment {
  Vec3 from;
  Vec3 direction;
  int band;
  Vec3 at(double distance) const { return from + distance * direction; }
};

MapRadiance::MapRadiance(const Problem& problem, std::vector<BandHits> hits, std::size_t neighbours)
    : problem_(problem),
      hits_(std::move(hits)),
      rays_(problem.mesh()),
      planes_(problem.mesh()),
      behind_(faces_behind(problem.mesh())) {
  for (const Wall& wall : problem.walls())
    for (std::size_t b = 0; b < static_cast<std::size_t>(problem.band_count()); ++b)
      formulas_.push_back(
          b < wall.radiance_by_direction.size() && wall.radiance_by_direction[b]
              ? std::make_unique<const FormulaEmitter>(problem, *wall.radiance_by_direction[b])
              : nullptr);
  for (BandHits& band : hits_) {
    surfaces_.emplace_back(problem.mesh(), planes_, neighbours, band.walls);
    volumes_.emplace_back(problem.mesh(), rays_, neighbours, band.matter);
  }
}

template <class Share>
Estimate MapRadiance::on_wall(FaceIndex face, const Vec3& point, int band, Workspace& work,
                              const Share& share) const {
  const SurfaceHits& surface = surfaces_[static_cast<std::size_t>(band)];
  surface.around(face, point, work.surface);
  if (work.surface.area <= 0) return {};
  Sum sum;
  for (const std::uint32_t number : work.surface.hits) sum.add(share(surface.hit(number)));
  return sum.times(surface.power() / work.surface.area);
}

Estimate MapRadiance::irradiance(FaceIndex face, const Vec3& point, int band, Workspace& work) const {
  return on_wall(face, point, band, work, [](const PhotonHit& hit) -> double { return hit.weight; });
}

Estimate MapRadiance::reflected(FaceIndex face, const Vec3& point, const Vec3& travel, int band,
                                Workspace& work) const {
  const Wall& wall = problem_.wall(problem_.mesh().wall(face));
  const auto b = static_cast<std::size_t>(band);
  const double factor = wall.diffuse[b] * std::numbers::inv_pi;
  const Reflectance* lobe = wall.glossy_in(b);
  const Vec3 normal = -problem_.mesh().area_normal(face).normalized();
  Estimate sum;
  if (factor > 0 || lobe != nullptr)
    sum = on_wall(face, point, band, work, [&](const PhotonHit& hit) {
      const double glossy = lobe != nullptr ? lobe->between(direction_of(hit), travel, normal) : 0;
      return (factor + glossy) * hit.weight;
    });
  if (wall.transmitted(b) == 0) return sum;
  const Estimate behind = irradiance(FaceIndex(behind_[face.at()]), point, band, work);
  const double through = wall.transmitted(b) * std::numbers::inv_pi;
  return {sum.value + through * behind.value, std::hypot(sum.error, through * behind.error)};
}

Estimate MapRadiance::scattered(CellIndex cell, const Vec3& point, const Vec3& travel, int band,
                                Workspace& work) const {
  const VolumeHits& volume = volumes_[static_cast<std::size_t>(band)];
  work.volume.radius = 0;
  if (!volume.around(cell, point, work.volume)) return {};
  const PhaseFunction& phase =
      problem_.medium(problem_.mesh().region(cell)).phase[static_cast<std::size_t>(band)];
  Sum sum;
  for (const std::uint32_t number : work.volume.hits) {
    const PhotonHit& hit = volume.hit(number);
    sum.add(phase_value(phase, std::clamp(direction_of(hit).dot(travel), -1.0, 1.0)) * hit.weight);
  }
  return sum.times(volume.power() / work.volume.volume);
}

double MapRadiance::emitted(FaceIndex face, const Vec3& point, const Vec3& travel, int band) const {
  const int number = problem_.mesh().wall(face);
  const double cosine = std::max(0.0, -travel.dot(problem_.mesh().area_normal(face).normalized()));
  const auto& formula = formulas_[static_cast<std::size_t>(number * problem_.band_count() + band)];
  return radiance_sent(problem_.wall(number), static_cast<std::size_t>(band), cosine) +
         (formula ? formula->at(point, travel) : 0);
}

double MapRadiance::along(const PointInCell& start, const Vec3& direction, int band, Workspace& work) const {
  double radiance = 0, left = 1;
  PointInCell at = start;
  Vec3 towards = direction;
  for (int i = 0; i < most_estimate_mirrors && left > faint_estimate; ++i) {
    const RaySegment segment{at.position, towards, band};
    work.parts.clear();
    const RayEnd end =
        rays_.walk(at.cell, at.position, towards, std::numeric_limits<double>::infinity(),
                   [&](CellIndex cell, double length) { work.parts.emplace_back(cell, length); });
    radiance += left * add_flat_lights(segment, end.distance, work);
    add_matter(segment, work, radiance, left);
    const Wall& wall = problem_.wall(problem_.mesh().wall(*end.wall));
    const auto b = static_cast<std::size_t>(band);
    const Vec3 normal = problem_.mesh().area_normal(*end.wall).normalized();
    const double cosine = std::max(0.0, towards.dot(normal));
    radiance += left * (emitted(*end.wall, end.point, -towards, band) +
                        reflected(*end.wall, end.point, -towards, band, work).value);
    left *= mirrored_part(wall, b, cosine);
    towards = (towards - 2 * towards.dot(normal) * normal).normalized();
    at = {end.cell, end.point};
  }
  return radiance;
}

// Lights inside the domain block no rays: all lights that the segment crosses are visible.
double MapRadiance::add_flat_lights(const RaySegment& segment, double length, const Workspace& work) const {
  double radiance = 0;
  for (const auto& [surface, distance] :
       transmitted_lights(problem_.lights(), segment.from, segment.direction, length)) {
    double depth = 0, reached = 0;
    for (const auto& [cell, part] : work.parts) {
      if (reached < distance) depth += extinction(cell, segment.band) * std::min(part, distance - reached);
      reached += part;
    }
    radiance += std::exp(-depth) * surface->radiance[static_cast<std::size_t>(segment.band)];
  }
  return radiance;
}

/// Takes the parts of each region that the ray crosses together.
void MapRadiance::add_matter(const RaySegment& segment, Workspace& work, double& radiance,
                             double& left) const {
  const TetrahedralMesh& mesh = problem_.mesh();
  double begin = 0;
  for (std::size_t first = 0, last = 0; first < work.parts.size() && left > faint_estimate; first = last) {
    double length = 0, depth = 0;
    const int region = mesh.region(work.parts[first].first);
    for (; last < work.parts.size() && mesh.region(work.parts[last].first) == region; ++last) {
      length += work.parts[last].second;
      depth += extinction(work.parts[last].first, segment.band) * work.parts[last].second;
    }
    radiance += left * march(segment, first, last, begin, work);
    left *= std::exp(-depth);
    begin += length;
  }
}

/// Emission of a cell that arrives along a piece of a ray, which begins at the distance `from`: with
/// q(s) = q_a + (q_b - q_a) s/l and the integrals E_0, E_1, q_a E_0 + (q_b - q_a) E_1/l.
double MapRadiance::emitted_along(CellIndex cell, const RaySegment& segment, double from, double length,
                                  const AttenuationIntegrals& integrals) const {
  const CellEmission& emission = problem_.cell_emission();
  const auto band = static_cast<std::size_t>(segment.band);
  if (!emission.varies_in(cell) || length <= 0) return emission.mean(cell, band) * integrals.constant;
  const auto emitted_at = [&](double distance) {
    const std::array<double, 4> at = barycentric(problem_.mesh(), cell, segment.at(distance));
    double sum = 0;
    for (std::size_t i = 0; i < at.size(); ++i) sum += at[i] * emission.at(cell, band, i);
    return sum;
  };
  const double near = emitted_at(from), far = emitted_at(from + length);
  return near * integrals.constant + (far - near) * integrals.linear / length;
}

/// Light of the parts [first, last), the first of which begins at the distance `begin`, where they begin.
double MapRadiance::march(const RaySegment& segment, std::size_t first, std::size_t last, double begin,
                          Workspace& work) const {
  double length = 0, scattering = 0;
  for (std::size_t i = first; i < last; ++i) {
    length += work.parts[i].second;
    scattering = std::max(scattering, problem_.scattering(work.parts[i].first, segment.band));
  }
  double radiance = 0, left = 1, reached = 0, used = 0, step = length / fewest_ball_steps, place = begin;
  for (std::size_t i = first; i < last && left > faint_estimate;) {
    double rest = scattering > 0 ? step : length, source = 0;
    if (scattering > 0) {
      std::size_t middle = i;
      for (double to = work.parts[i].second - used; middle + 1 < last && to < step / 2;)
        to += work.parts[++middle].second;
      const double where = std::min(reached + step / 2, length);
      source = scattered(work.parts[middle].first, segment.at(begin + where), -segment.direction,
                         segment.band, work)
                   .value;
      step = std::clamp(step_in_radii * work.volume.radius, length / most_ball_steps,
                        length / fewest_ball_steps);
    }
    reached += rest;
    while (rest > 0 && i < last) {
      const auto [cell, part] = work.parts[i];
      const double piece = std::min(rest, part - used), sigma = extinction(cell, segment.band);
      const bool scatters = problem_.scattering(cell, segment.band) > 0;
      const AttenuationIntegrals integrals = attenuation_integrals(sigma, piece);
      radiance += left * (emitted_along(cell, segment, place, piece, integrals) +
                          (scatters ? source * integrals.constant : 0));
      left *= std::exp(-sigma * piece);
      place += piece;
      rest -= piece;
      used += piece;
      if (used >= part) {
        ++i;
        used = 0;
      }
    }
  }
  return radiance;
}

}  // namespace etendue
