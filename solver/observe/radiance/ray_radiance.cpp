// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/radiance/ray_radiance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/quadrature/gauss_legendre.h"
#include "mesh/tetrahedra/barycentric.h"
#include "solver/observe/radiance/lit_triangle.h"
#include "solver/observe/radiance/quadratic_reconstruction.h"
#include "solver/observe/radiance/ray_radiance_segment.h"
#include "solver/problem/mirror.h"
#include "solver/uncollided/rays/attenuation.h"
#include "solver/uncollided/sources/sky_source.h"

namespace etendue {
namespace {

/// A ray is given up where less than this of its light is left, which is less than a picture's numbers
/// resolve, and after so many mirrors.
constexpr double faint_ray = 1e-8;
constexpr int most_ray_mirrors = 10000;

/// A ray has come back to where it was where place and direction are within this part of its path length.
constexpr double same_place = 1e-12;

/// Interpolates values at the vertices, with the quadratic part of a quadratic_reconstruction() if there is
/// one.
double interpolated(std::span<const double> values, const std::array<double, 4>& at, std::size_t band,
                    std::size_t bands) {
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) sum += at[i] * values[i * bands + band];
  for (std::size_t e = 0; (4 + e) * bands < values.size(); ++e)
    sum += 4 * at[cell_edges[e].first] * at[cell_edges[e].second] * values[(4 + e) * bands + band];
  return sum;
}

}  // namespace

/// State of a ray at its first mirror: the radiance before it [band] and the weight of the radiance beyond it
/// [band].
struct RayRadiance::FirstReflection {
  Vec3 position;
  Vec3 towards;
  std::vector<double> radiance;
  std::vector<double> weight;
};

RayRadiance::RayRadiance(const LightSetup& lights, const DirectionSet& directions,
                         const SolveOptions& options, const SavedState& state, int threads, WallValues walls,
                         std::shared_ptr<const FirstCollisions> first)
    : lights_(lights),
      problem_(lights.problem()),
      bands_(lights.paths().bands()),
      collided_(lights, directions, options, state),
      once_(lights, first ? std::move(first) : find_first_collisions(lights, threads)),
      walls_(lights, directions, state, options.order == SpaceOrder::linear ? 3 : 1, walls),
      entry_(problem_.mesh()) {
  find_dark_cells();
}

RayRadiance::Workspace::Workspace(const RayRadiance& radiance)
    : beams(radiance.bands_),
      memory(radiance.once_),
      values(radiance.collided_.value_count() * radiance.bands_),
      depth(radiance.bands_),
      depth_rest(radiance.bands_),
      factor(radiance.bands_),
      at_point(radiance.bands_) {
  for (const Wall& wall : radiance.problem_.walls()) wall_formulas.push_back(wall.radiance_by_direction);
}

void RayRadiance::find_dark_cells() {
  for (std::int32_t c = 0; c < problem_.mesh().cell_count(); ++c) {
    bool dark = !collided_.swept_lights().depends_on_direction(CellIndex(c));
    for (int b = 0; b < problem_.band_count(); ++b)
      dark = dark && problem_.absorption(CellIndex(c), b) == 0 && problem_.scattering(CellIndex(c), b) == 0 &&
             problem_.emission(CellIndex(c), b) == 0;
    is_void_.push_back(dark ? 1 : 0);
  }
}

RayEnd RayRadiance::walk(const PointInCell& from, const Vec3& direction, Workspace& work) const {
  work.parts.clear();
  double reached = 0;
  return lights_.paths().rays().walk(from.cell, from.position, direction,
                                     std::numeric_limits<double>::infinity(),
                                     [&](CellIndex cell, double length) {
                                       if (length > 0 && is_void_[cell.at()] == 0)
                                         work.parts.push_back({cell, reached, length});
                                       reached += length;
                                     });
}

void RayRadiance::along(const PointInCell& start, const Vec3& direction, const RayView& view, Workspace& work,
                        std::span<double> radiance) const {
  std::fill(radiance.begin(), radiance.end(), 0.0);
  std::fill(work.depth.begin(), work.depth.end(), 0.0);
  std::fill(work.depth_rest.begin(), work.depth_rest.end(), 0.0);
  std::fill(work.factor.begin(), work.factor.end(), 1.0);
  PointInCell at = start;
  Vec3 towards = direction;
  std::optional<FirstReflection> first;
  double path_length = 0;
  for (int i = 0; i < most_ray_mirrors; ++i) {
    const RayEnd end = walk(at, towards, work);
    const RaySegment segment{at.position, towards, view, lights_.paths().matter().view(-towards),
                             i > 0 || view.first_wall_diffuse};
    if (view.lights_shown) add_flat_lights(segment, end.distance, work, radiance);
    add_cells(segment, work, radiance);
    add_wall(*end.wall, end.point, segment, work, radiance);
    if (view.lights_shown) add_skies(*end.wall, segment, work, radiance);
    add_glossy(*end.wall, end.point, segment, work, radiance);
    const Vec3 normal = problem_.mesh().area_normal(*end.wall).normalized();
    if (!reflect(*end.wall, towards.dot(normal), work)) return;
    towards = (towards - 2 * towards.dot(normal) * normal).normalized();
    at = {end.cell, end.point};
    path_length += end.distance;
    if (!first)
      first = FirstReflection{at.position, towards, {radiance.begin(), radiance.end()}, weights_left(work)};
    else if ((at.position - first->position).norm() < same_place * path_length &&
             (towards - first->towards).norm() < same_place && end_series(*first, work, radiance))
      return;
  }
}

RayRadiance::DiffuseWall RayRadiance::diffuse_wall(const PointInCell& start, const Vec3& direction,
                                                   std::span<const double> irradiance,
                                                   Workspace& work) const {
  const RayEnd end = walk(start, direction, work);
  DiffuseWall wall{end.distance, std::vector<double>(bands_, 0)};
  walls_.add_reflected(*end.wall, end.point, walls_.brought(), irradiance, wall.radiance);
  walls_.add_transmitted(*end.wall, end.point, walls_.brought(), fine_shadow_rays, work.beams, wall.radiance);
  return wall;
}

std::vector<double> RayRadiance::weights_left(const Workspace& work) const {
  std::vector<double> weights;
  for (std::size_t b = 0; b < bands_; ++b) weights.push_back(work.factor[b] * std::exp(-work.depth_rest[b]));
  return weights;
}

// Between mirrors that face each other the ray goes round and round: with X of light on the first round and
// w < 1 of the weight left after it the series X (1 + w + w^2 + …) is X/(1 - w). Not so where lights and the
// rest see different extinctions.
bool RayRadiance::end_series(const FirstReflection& first, const Workspace& work,
                             std::span<double> radiance) const {
  if (work.depth != work.depth_rest) return false;
  const std::vector<double> left = weights_left(work);
  for (std::size_t b = 0; b < bands_; ++b) {
    const double kept = first.weight[b] > 0 ? left[b] / first.weight[b] : 0;
    // Where nothing is lost nothing shines.
    if (kept < 1) radiance[b] = first.radiance[b] + (radiance[b] - first.radiance[b]) / (1 - kept);
  }
  return true;
}

void RayRadiance::add_cells(const RaySegment& segment, Workspace& work, std::span<double> radiance) const {
  work.view.reset();
  work.memory.forget();
  for (const Workspace::Part& part : work.parts) {
    if (!work.view) work.view = collided_.view(segment.travel());
    if (segment.view.shafts > 0 && !lights_.empty()) add_shafts(segment, part, work, radiance);
    add_part(segment, part, work, radiance);
  }
}

// With S(s) = S_a + (S_b - S_a) s/l over the length l of the part, and E_0, E_1 of attenuation_integrals:
//   integral of S e^(-sigma s) ds = S_a E_0 + (S_b - S_a) E_1/l,
// and the quadratic part in the middle times attenuated_quadratic.
void RayRadiance::add_part(const RaySegment& segment, const Workspace::Part& part, Workspace& work,
                           std::span<double> radiance) const {
  collided_.values(part.cell, *work.view, work.values);
  collided_.swept_lights().add_points(segment.travel(), part.cell, std::span(work.values).first(4 * bands_));
  if (segment.view.shafts == 0) once_.add_at_vertices(part.cell, segment.travel(), work.memory, work.values);
  const auto here = barycentric(problem_.mesh(), part.cell, segment.at(part.from));
  const auto there = barycentric(problem_.mesh(), part.cell, segment.at(part.from + part.length));
  const bool is_quadratic = collided_.value_count() > 4;
  std::array<double, 4> middle;
  for (std::size_t i = 0; i < 4; ++i) middle[i] = (here[i] + there[i]) / 2;
  const bool is_light = segment.view.lights_shown && lights_.has_region(problem_.mesh().region(part.cell));
  for (std::size_t b = 0; b < bands_; ++b) {
    const double near = interpolated(work.values, here, b, bands_);
    const double far = interpolated(work.values, there, b, bands_);
    const double extinction = collided_.extinction(part.cell, b, *work.view);
    const AttenuationIntegrals integrals = attenuation_integrals(extinction, part.length);
    double arrives = near * integrals.constant + (far - near) * integrals.linear / part.length;
    if (is_quadratic)
      arrives += (interpolated(work.values, middle, b, bands_) - (near + far) / 2) *
                 attenuated_quadratic(extinction, part.length);
    radiance[b] += work.factor[b] * std::exp(-work.depth_rest[b]) * arrives;
    const double whole = lights_.paths().extinction(part.cell, b, segment.light);
    if (is_light)
      radiance[b] += work.factor[b] * std::exp(-work.depth[b]) *
                     problem_.emission(part.cell, static_cast<int>(b)) *
                     attenuation_integrals(whole, part.length).constant;
    work.depth_rest[b] += extinction * part.length;
    work.depth[b] += whole * part.length;
  }
}

void RayRadiance::add_shafts(const RaySegment& segment, const Workspace::Part& part, Workspace& work,
                             std::span<double> radiance) const {
  const GaussRule rule = gauss_legendre(segment.view.shafts);
  bool scatters = false;
  for (int b = 0; b < problem_.band_count(); ++b)
    scatters = scatters || problem_.scattering(part.cell, b) > 0;
  for (std::size_t i = 0; i < rule.nodes.size() && scatters; ++i) {
    const double along = part.length * (1 + rule.nodes[i]) / 2;
    std::fill(work.at_point.begin(), work.at_point.end(), 0.0);
    once_.add_at({part.cell, segment.at(part.from + along)}, segment.travel(), work.beams, work.at_point);
    for (std::size_t b = 0; b < bands_; ++b)
      radiance[b] += work.factor[b] * part.length * rule.weights[i] / 2 * work.at_point[b] *
                     std::exp(-work.depth_rest[b] - collided_.extinction(part.cell, b, *work.view) * along);
  }
}

// Lights inside the domain block no rays: all lights that the segment crosses are visible.
void RayRadiance::add_flat_lights(const RaySegment& segment, double length, Workspace& work,
                                  std::span<double> radiance) const {
  for (const auto& [surface, distance] :
       transmitted_lights(problem_.lights(), segment.from, segment.direction, length))
    for (std::size_t band = 0; band < bands_; ++band) {
      double depth = work.depth[band];
      for (const Workspace::Part& part : work.parts)
        if (part.from < distance)
          depth += lights_.paths().extinction(part.cell, band, segment.light) *
                   std::min(part.length, distance - part.from);
      radiance[band] += work.factor[band] * std::exp(-depth) * surface->radiance[band];
    }
}

void RayRadiance::add_skies(FaceIndex face, const RaySegment& segment, const Workspace& work,
                            std::span<double> radiance) const {
  for (const auto& source : lights_.sources()) {
    const WideSource* wide = source->as_wide();
    const SkySource* sky = wide != nullptr ? wide->as_sky() : nullptr;
    if (sky == nullptr || !sky->shows_radiance() || !sky->comes_in_by(problem_.mesh().wall(face))) continue;
    const std::span<const double> of_sky = sky->radiance(segment.direction);
    for (std::size_t b = 0; b < bands_; ++b)
      radiance[b] += work.factor[b] * std::exp(-work.depth[b]) * of_sky[b];
  }
}

void RayRadiance::add_wall(FaceIndex face, const Vec3& point, const RaySegment& segment, Workspace& work,
                           std::span<double> radiance) const {
  const RayView& view = segment.view;
  const int number = problem_.mesh().wall(face);
  const Wall& wall = problem_.wall(number);
  std::fill(work.at_point.begin(), work.at_point.end(), 0.0);
  if (segment.wall_is_diffuse)
    walls_.add_reflected(face, point, view.brought != nullptr ? *view.brought : walls_.brought(),
                         view.shadow_rays, work.beams, work.at_point);
  walls_.add_following(face, point, work.at_point);
  for (std::size_t b = 0; b < bands_; ++b) {
    const double rest = std::exp(-work.depth_rest[b]);
    double emitted = rest;
    if (lights_.has_wall(number)) emitted = view.lights_shown ? std::exp(-work.depth[b]) : 0;
    const double sent = radiance_sent(
        wall, b, -segment.travel().dot(problem_.mesh().area_normal(face)) / problem_.mesh().area(face));
    radiance[b] += work.factor[b] * (rest * work.at_point[b] + emitted * sent);
  }
  const auto& formulas = work.wall_formulas[static_cast<std::size_t>(number)];
  for (std::size_t b = 0; b < formulas.size(); ++b)
    if (formulas[b])
      radiance[b] +=
          work.factor[b] * std::exp(-work.depth_rest[b]) * formulas[b]->at(point, segment.travel());
}

/// Returns whether the ray continues.
bool RayRadiance::reflect(FaceIndex face, double cosine, Workspace& work) const {
  const Wall& wall = problem_.wall(problem_.mesh().wall(face));
  double left = 0;
  for (std::size_t b = 0; b < bands_; ++b) {
    work.factor[b] *= mirrored_part(wall, b, cosine);
    left = std::max(left, work.factor[b] * std::exp(-std::min(work.depth_rest[b], work.depth[b])));
  }
  return left > faint_ray;
}

}  // namespace etendue
