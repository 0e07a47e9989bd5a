// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/projection/extended_light.h"

#include <algorithm>
#include <cmath>

#include "base/quadrature/simplex_rules.h"
#include "solver/uncollided/closed_form/cut_simplex.h"
#include "solver/uncollided/projection/adaptive_points.h"

namespace etendue {
namespace {

/// Cells that are nearer to a surface that shines than this many of their sizes are divided where its light
/// varies steeply, and up to so many sizes they have a rule of degree 5, as all faces have.
constexpr double touching_in_sizes = 1e-9, light_near_in_sizes = 1.5, middling_in_sizes = 4;
constexpr double tolerance_of_cells = 1e-3, tolerance_of_faces = 1e-4;
constexpr int divisions_of_cells = 2, divisions_of_faces = 5;
/// Cells larger than the light once more for each time that their size has to be halved, so often at most.
constexpr int divisions_to_light = 4;
/// Cells in and near a volume that shines in many ways are sampled point by point where they are thicker
/// than this.
constexpr double thick_for_volume = 1;
/// How often a cell or face with a part in the shadow is divided. Less than this part of the light in the
/// shadow, or out of it, is rounding.
constexpr int divisions_in_shadow = 2, divisions_along_edges = 1;
constexpr double trifle_of_light = 1e-9;
/// Triangles of a light up to which cells in its penumbra see them cut along edges.
constexpr std::size_t most_cut_in_cells = 8;

/// In penumbras faces are divided while that changes their light by more than this part of it, and so often
/// at most.
constexpr double penumbra_tolerance = 1e-3;
constexpr int divisions_in_penumbra = 4;

/// How finely walls see a light of which they see a part: to the sides of a box it sinks below the horizon.
constexpr LightDetail wall_in_shadow{0.25, 0.03, 0.3, 0.9, TriangleRule::seven_points};
/// Specular reflectance above which a mirror counts as one that sends all light back.
constexpr double nearly_all = 0.95;

const auto& rule_of_degree_two(const SubTetrahedron&) { return four_point_rule(); }
const auto& rule_of_degree_two(const SubTriangle&) { return three_point_rule(); }

}  // namespace

/// Light at a point, [band], through a homogeneous medium, and the extinction of that medium [1/length].
struct ExtendedLight::Arrived : HomogeneousLight {
  explicit Arrived(std::size_t bands) : HomogeneousLight(bands), extinction(bands) {}
  std::vector<double> extinction;
};

/// A cell or a face as its light is integrated.
template <std::size_t corners>
struct ExtendedLight::Site {
  using Barycentric = std::array<double, corners>;
  using Part = std::array<Barycentric, corners>;

  CellIndex cell;
  std::array<Vec3, corners> corner;
  Vec3 centroid;
  double measure, size;
  Part whole;
  bool counts;  ///< whether light is lost in it

  Vec3 position(const Barycentric& barycentric) const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < corners; ++i) sum += barycentric[i] * corner[i];
    return sum;
  }
};

ExtendedLight::ExtendedLight(const LightPaths& paths, const ExtendedSource& source,
                             const std::vector<ShadowEdge>& shadow_edges, int threads, RankGroup* ranks)
    : paths_(paths),
      source_(source),
      bands_(paths.bands()),
      vertex_attenuation_(paths, source, threads, ranks),
      edges_(paths, source, shadow_edges) {}

// Much larger cells hold nearly the light of a point.
int ExtendedLight::divisions_of(const LitCell& cell) const {
  const double halvings = std::ceil(std::log2(cell.size / source_.diameter()));
  return divisions_of_cells + static_cast<int>(std::clamp<double>(halvings, 0, divisions_to_light));
}

// The points of the rule have one barycentric coordinate 1 - (n - 1) a and the others a. Those behind the
// light take the mean of the others.
template <std::size_t corners>
bool ExtendedLight::sample_inside(const Site<corners>& site, LightBeams& beams,
                                  InterpolatedAttenuation<corners>& interpolated) const {
  const auto& rule = rule_of_degree_two(site.whole);
  std::array<Visibility, corners> visibility{};
  double lit = 0;
  for (std::size_t i = 0; i < corners; ++i) {
    interpolated.corner[i].resize(bands_);
    visibility[i] = sample(source_, {site.cell, site.position(rule[i].barycentric)}, coarse_light, beams,
                           interpolated.corner[i]);
    if (visibility[i] == Visibility::nothing || visibility[i] == Visibility::part) return false;
    lit += visibility[i] == Visibility::all ? 1 : 0;
  }
  if (lit == 0) return false;
  constexpr auto count = static_cast<double>(corners);
  const double a = rule[0].barycentric[1];
  for (std::size_t b = 0; b < bands_; ++b) {
    PathAttenuation mean;
    for (std::size_t i = 0; i < corners; ++i)
      if (visibility[i] == Visibility::all) {
        mean.extinction += interpolated.corner[i][b].extinction / lit;
        mean.deflection += interpolated.corner[i][b].deflection / lit;
      }
    for (std::size_t i = 0; i < corners; ++i) {
      PathAttenuation& own = interpolated.corner[i][b];
      if (visibility[i] != Visibility::all) own = mean;
      own = {1, mean.extinction + (own.extinction - mean.extinction) / (1 - count * a),
             mean.deflection + (own.deflection - mean.deflection) / (1 - count * a)};
    }
  }
  return true;
}

void ExtendedLight::arrive(const Vec3& place, std::span<const PathAttenuation> attenuation, LightBeams& beams,
                           Arrived& light) const {
  for (std::size_t b = 0; b < bands_; ++b) light.extinction[b] = std::max(0.0, attenuation[b].extinction);
  source_.evaluate_homogeneous(place, light.extinction, std::nullopt, beams, light);
  for (std::size_t b = 0; b < bands_; ++b) {
    light.flux[b] = attenuation[b].visible * (light.flux[b] + light.fluence[b] * attenuation[b].deflection);
    light.fluence[b] *= attenuation[b].visible;
  }
}

// Corners on one side of the rim count; of those on several the one in which these meet.
template <std::size_t corners>
SteepCorners<corners> ExtendedLight::steep_corners(
    const Site<corners>& site, const std::array<std::array<double, corners>, corners>& part) const {
  const double touching = touching_in_sizes * site.size;
  SteepCorners<corners> steep;
  std::bitset<32> common = std::bitset<32>().set();
  std::bitset<corners> several;
  for (std::size_t i = 0; i < corners; ++i) {
    const Vec3 place = site.position(part[i]);
    steep.surface[i] = source_.is_near(place, touching);
    if (!steep.surface[i]) continue;
    const std::bitset<32> sides = source_.rim_sides_at(place, touching);
    steep.rim[i] = sides.any();
    several[i] = sides.count() > 1;
    if (sides.any()) common &= sides;
  }
  if (common.none()) steep.rim = several.count() == 1 ? several : std::bitset<corners>();
  return steep;
}

// Of a light in one plane the fluence is not steady across that plane.
template <std::size_t corners, class AddPoint>
void ExtendedLight::integrate(const Site<corners>& site, double tolerance, int divisions,
                              const AddPoint& add_point, NodalMoments& moments) const {
  const auto add_part = [&](const auto& part, double measure) {
    add_adaptively(
        part, measure, [&](const auto& piece) { return steep_corners(site, piece); }, tolerance, divisions,
        add_point, moments);
  };
  const auto& plane = source_.plane();
  if (!plane) return add_part(site.whole, site.measure);
  std::array<double, corners> height;
  for (std::size_t i = 0; i < corners; ++i) height[i] = plane->signedDistance(site.corner[i]);
  cut_simplex<corners>(site.whole, height, touching_in_sizes * site.size, site.measure, add_part);
}

template <std::size_t corners, class Deposit>
void ExtendedLight::add_lit(const Site<corners>& site, const InterpolatedAttenuation<corners>& interpolated,
                            int divisions, const Deposit& deposit, LightBeams& beams,
                            NodalMoments& moments) const {
  Arrived light(bands_);
  std::vector<PathAttenuation> attenuation(bands_);
  const auto add_point = [&](const std::array<double, corners>& barycentric, double measure,
                             NodalMoments& sum) {
    const Vec3 place = site.position(barycentric);
    for (std::size_t b = 0; b < bands_; ++b) attenuation[b] = interpolated.at(barycentric, b);
    arrive(place, attenuation, beams, light);
    deposit(place, barycentric, measure, light, sum);
  };
  const bool middling = corners == 3 || source_.is_near(site.centroid, middling_in_sizes * site.size);
  if (source_.is_in_parts() || !middling) {
    for (const auto& point : rule_of_degree_two(site.whole))
      add_point(point.barycentric, point.weight * site.measure, moments);
    return;
  }
  const bool near = source_.is_near(site.centroid, light_near_in_sizes * site.size);
  integrate(site, corners == 3 ? tolerance_of_faces : tolerance_of_cells, near ? divisions : 0, add_point,
            moments);
}

template <std::size_t corners, class Deposit>
void ExtendedLight::add_point_by_point(const Site<corners>& site,
                                       const std::array<std::array<double, corners>, corners>& part,
                                       double measure, int divisions, const LightDetail& detail,
                                       const Deposit& deposit, LightBeams& beams,
                                       NodalMoments& moments) const {
  NodalMoments sum = moments;
  sum.clear();
  Arrived light(bands_);
  std::vector<PathAttenuation> attenuation(bands_);
  bool any_lit = false, any_shadow = false;
  const auto add_sample = [&](const auto& point) {
    const auto barycentric = in_whole(point.barycentric, part);
    const Vec3 place = site.position(barycentric);
    const Visibility visibility = sample(source_, {site.cell, place}, detail, beams, attenuation);
    const double visible = visibility == Visibility::behind ? 0 : attenuation[0].visible;
    any_lit = any_lit || visible > trifle_of_light;
    any_shadow = any_shadow || (visibility != Visibility::behind && visible < 1 - trifle_of_light);
    arrive(place, attenuation, beams, light);
    deposit(place, barycentric, point.weight * measure, light, sum);
  };
  if (divisions == 0 && source_.is_near(site.centroid, middling_in_sizes * site.size))
    for (const auto& point : detail::rule_of_degree_five(part)) add_sample(point);
  else
    for (const auto& point : rule_of_degree_two(part)) add_sample(point);
  if (!any_lit || !any_shadow || divisions == 0) return moments.add(sum);
  const auto parts = equal_parts(part);
  for (const auto& child : parts)
    add_point_by_point(site, child, measure / static_cast<double>(parts.size()), divisions - 1, detail,
                       deposit, beams, moments);
}

template <std::size_t corners, class Deposit>
void ExtendedLight::add_along_rays(const Site<corners>& site, const LightDetail& detail, double tolerance,
                                   int divisions, const Deposit& deposit, LightBeams& beams,
                                   NodalMoments& moments) const {
  Arrived light(bands_);
  std::vector<PathAttenuation> attenuation(bands_);
  const auto add_point = [&](const std::array<double, corners>& barycentric, double measure,
                             NodalMoments& sum) {
    const Vec3 place = site.position(barycentric);
    sample(source_, {site.cell, place}, detail, beams, attenuation);
    arrive(place, attenuation, beams, light);
    deposit(place, barycentric, measure, light, sum);
  };
  integrate(site, tolerance, divisions, add_point, moments);
}

template <std::size_t corners, class Deposit>
void ExtendedLight::add(const Site<corners>& site, const std::array<std::int32_t, corners>& vertices,
                        const std::vector<ShadowEdge>& edges, int divisions, const Deposit& deposit,
                        LightBeams& beams, NodalMoments& moments) const {
  InterpolatedAttenuation<corners> interpolated;
  const Interpolation found = vertex_attenuation_.take(vertices, interpolated);
  const bool known = found == Interpolation::possible || (found == Interpolation::steep && !site.counts);
  if (edges.empty() &&
      (known || (found == Interpolation::unseen && sample_inside(site, beams, interpolated))))
    return add_lit(site, interpolated, divisions, deposit, beams, moments);
  LightDetail detail = corners == 3 ? wall_in_shadow : coarse_light;
  if (!edges.empty()) detail.shadow_edges = &edges;
  if (source_.plane() && source_.is_near(site.centroid, light_near_in_sizes * site.size))
    return corners == 3 ? add_along_rays(site, detail, penumbra_tolerance, divisions_in_penumbra, deposit,
                                         beams, moments)
                        : add_along_rays(site, detail, tolerance_of_cells, divisions_of_cells, deposit, beams,
                                         moments);
  int in_shadow = found == Interpolation::steep ? 0 : divisions_in_shadow;
  if (!edges.empty()) in_shadow = divisions_along_edges;
  add_point_by_point(site, site.whole, site.measure, in_shadow, detail, deposit, beams, moments);
}

void ExtendedLight::add(const LitCell& cell, LightBeams& beams, NodalMoments& moments) const {
  const Site<4> site{cell.index, cell.corners, cell.centroid,     cell.volume,
                     cell.size,  whole_cell(), cell.thickness > 0};
  const auto deposit = [this](const Vec3&, const std::array<double, 4>& shape, double measure,
                              const Arrived& light, NodalMoments& sum) {
    for (std::size_t b = 0; b < bands_; ++b) {
      sum.add(shape, measure, b, light.fluence[b]);
      for (std::size_t axis = 0; axis < 3; ++axis)
        sum.add(shape, measure, b, light.flux[b][static_cast<Eigen::Index>(axis)], 1 + axis);
    }
  };
  if (source_.is_in_parts() && cell.thickness > thick_for_volume &&
      source_.is_near(cell.centroid, light_near_in_sizes * cell.size))
    return add_point_by_point(site, site.whole, site.measure, 0, coarse_light, deposit, beams, moments);
  std::vector<ShadowEdge> edges;
  if (source_.flat_parts().size() <= most_cut_in_cells) edges = edges_.before(site.corner);
  add(site, paths_.problem().mesh().vertices(cell.index), edges, divisions_of(cell), deposit, beams, moments);
}

// What is not sent back by a mirror travels out of the domain: (1 - r) E = F.n. Where nearly all is sent back
// that says little, and E = phi / (1 + r) times the mean cosine of the light before the mirror.
void ExtendedLight::add(FaceIndex face, LightBeams& beams, NodalMoments& moments) const {
  const TetrahedralMesh& mesh = paths_.problem().mesh();
  const double area = mesh.area(face);
  const Vec3 normal = mesh.area_normal(face) / area;
  const auto& vertices = mesh.vertices(face);
  const int plane = paths_.mirrors().of(face);
  Site<3> site{mesh.owner(face), {}, mesh.centroid(face), area, std::sqrt(2 * area), whole_face, true};
  for (std::size_t i = 0; i < 3; ++i) site.corner[i] = mesh.point(VertexIndex(vertices[i]));
  const std::vector<double>& reflected = paths_.problem().wall(mesh.wall(face)).specular;
  LightBeams before(bands_);
  HomogeneousLight homogeneous(bands_);
  const auto deposit = [&](const Vec3& place, const std::array<double, 3>& shape, double measure,
                           const Arrived& light, NodalMoments& sum) {
    if (plane >= 0) source_.evaluate_homogeneous(place, light.extinction, plane, before, homogeneous);
    for (std::size_t b = 0; b < bands_; ++b) {
      double irradiance = light.flux[b].dot(normal) / (1 - reflected[b]);
      if (reflected[b] > nearly_all)
        irradiance = homogeneous.fluence[b] > 0 ? light.fluence[b] / (1 + reflected[b]) *
                                                      homogeneous.flux[b].dot(normal) / homogeneous.fluence[b]
                                                : 0;
      sum.add(shape, measure, b, std::max(0.0, irradiance));
    }
  };
  const std::vector<ShadowEdge> edges = edges_.before(site.corner);
  if (edges.empty()) return add(site, vertices, edges, divisions_of_faces, deposit, beams, moments);
  LightDetail detail = wall_in_shadow;
  detail.shadow_edges = &edges;
  add_along_rays(site, detail, penumbra_tolerance, divisions_in_penumbra, deposit, beams, moments);
}

}  // namespace etendue
