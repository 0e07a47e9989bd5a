// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/radiance/wall_light.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <numbers>

#include "base/field_view.h"
#include "mesh/tetrahedra/sheet_faces.h"
#include "solver/uncollided/sources/wide_source.h"

namespace etendue {
namespace {

/// Transmittances to a light that differ by more show where each ray ends.
constexpr double uneven = 0.1;

/// Triangles of a lamp that are cut, each seen by several rays, and of one whose light in empty space is
/// added up: a disc has 62.
constexpr std::size_t most_cut = 24, most_known = 256;

/// Rays to a light with an extent that tell whether more are needed.
constexpr int few_rays = 16;

/// From one detail to the next coarser one, and an opening within which all of a light is one.
constexpr double detail_growth = 1.3, whole_opening = 20;

/// Returns whether a light is made of triangles, and of so many at most.
bool is_flat(const LightSource& source, std::size_t most) {
  const WideSource* wide = source.as_wide();
  return wide != nullptr && !wide->flat_parts().empty() && wide->flat_parts().size() <= most;
}

bool is_of_walls(const ShadowEdge& edge) {
  return std::ranges::any_of(edge.surfaces,
                             [](const ShadowEdge::Surface& surface) { return surface.wall >= 0; });
}

}  // namespace

LightDetail detail_within(const LightSource& source, const PointInCell& point, LightDetail detail, int rays,
                          LightBeams& beams) {
  while (true) {
    beams.clear();
    source.add_beams(point, Sight::clear, detail, beams);
    if (beams.size() <= static_cast<std::size_t>(rays) || detail.opening > whole_opening) return detail;
    for (double* size : {&detail.opening, &detail.single, &detail.thickness, &detail.largest_side})
      *size *= detail_growth;
  }
}

WallLight::WallLight(const LightSetup& lights, const DirectionSet& directions, const SavedState& state,
                     std::size_t face_nodes, WallValues values)
    : lights_(lights),
      problem_(lights.problem()),
      bands_(lights.paths().bands()),
      irradiance_(lights),
      behind_(faces_behind(problem_.mesh())) {
  std::ranges::copy_if(lights.shadow_edges(), std::back_inserter(edges_), is_of_walls);
  const TetrahedralMesh& mesh = problem_.mesh();
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
    brought_.half_range.push_back(directions.half_range(mesh.area_normal(FaceIndex(f)).normalized()));
  if (state.irradiance.size() != brought_.half_range.size() * face_nodes * bands_)
    throw InputError("the saved state is not of this kind (another mesh or other elements)");
  brought_.values = values == WallValues::raw && face_nodes == 3
                        ? state.irradiance
                        : joined_on_planes(mesh, state.irradiance, face_nodes, bands_);
  const std::vector<double>& following = problem_.following().radiance;
  if (!following.empty())
    following_ = values == WallValues::raw ? following
                                           : joined_on_planes(mesh, following, 3, bands_, WallBorders::cut);
}

void WallLight::add_reflected(FaceIndex face, const Vec3& point, const WallIrradiance& brought,
                              int shadow_rays, LightBeams& beams, std::span<double> radiance) const {
  const Wall& wall = problem_.wall(problem_.mesh().wall(face));
  if (std::ranges::any_of(wall.diffuse, [](double value) { return value > 0; }))
    add_sent_on(face, point, wall.diffuse, brought, shadow_rays, beams, radiance);
  add_transmitted(face, point, brought, shadow_rays, beams, radiance);
}

void WallLight::add_transmitted(FaceIndex face, const Vec3& point, const WallIrradiance& brought,
                                int shadow_rays, LightBeams& beams, std::span<double> radiance) const {
  const Wall& wall = problem_.wall(problem_.mesh().wall(face));
  if (wall.transmits())
    add_sent_on(FaceIndex(behind_[face.at()]), point, wall.transmittance, brought, shadow_rays, beams,
                radiance);
}

void WallLight::add_sent_on(FaceIndex face, const Vec3& point, std::span<const double> share,
                            const WallIrradiance& brought, int shadow_rays, LightBeams& beams,
                            std::span<double> radiance) const {
  const Vec3 outwards = problem_.mesh().area_normal(face).normalized();
  std::vector<double> irradiance(bands_, 0);
  add_light({problem_.mesh().owner(face), point}, outwards, shadow_rays, beams, irradiance);
  add_sent_on(face, point, share, brought, irradiance, radiance);
}

void WallLight::add_reflected(FaceIndex face, const Vec3& point, const WallIrradiance& brought,
                              std::span<const double> irradiance, std::span<double> radiance) const {
  add_sent_on(face, point, problem_.wall(problem_.mesh().wall(face)).diffuse, brought, irradiance, radiance);
}

void WallLight::add_sent_on(FaceIndex face, const Vec3& point, std::span<const double> share,
                            const WallIrradiance& brought, std::span<const double> irradiance,
                            std::span<double> radiance) const {
  const std::array<double, 3> weights = barycentric(problem_.mesh(), face, point);
  const double half_range = brought.half_range[face.at()];
  const ConstFaceField values(brought.values, bands_);
  for (std::size_t i = 0; i < 3 && half_range > 0; ++i)
    for (std::size_t b = 0; b < bands_; ++b)
      radiance[b] += share[b] / half_range * weights[i] * values(face, i, b);
  for (std::size_t b = 0; b < bands_; ++b) radiance[b] += share[b] * std::numbers::inv_pi * irradiance[b];
}

void WallLight::add_following(FaceIndex face, const Vec3& point, std::span<double> radiance) const {
  if (following_.empty() || !problem_.wall(problem_.mesh().wall(face)).emission_follows) return;
  const std::array<double, 3> weights = barycentric(problem_.mesh(), face, point);
  const ConstFaceField values(following_, bands_);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t b = 0; b < bands_; ++b) radiance[b] += weights[i] * values(face, i, b);
}

void WallLight::add_light(const PointInCell& point, const Vec3& normal, int shadow_rays, LightBeams& beams,
                          std::span<double> irradiance) const {
  LightBeams clear(bands_);
  UncollidedAtPoint light{std::vector<double>(bands_, 0), std::vector<double>(bands_, 0)};
  for (const auto& source : lights_.sources()) {
    find_beams(*source, point, shadow_rays, beams, clear);
    if (!is_flat(*source, most_known)) clear.clear();
    irradiance_.add(*source, point.position, -normal, beams, clear, light);
  }
  for (std::size_t b = 0; b < bands_; ++b) irradiance[b] += light.irradiance[b];
}

void WallLight::find_beams(const LightSource& source, const PointInCell& point, int shadow_rays,
                           LightBeams& beams, LightBeams& clear) const {
  const auto look = [&](Sight sight, LightDetail detail, LightBeams& found) {
    found.clear();
    source.add_beams(point, sight, detail, found);
  };
  clear.clear();
  if (source.as_wide() == nullptr) return look(Sight::attenuated, wall_light_detail, beams);
  if (shadow_rays > few_rays && is_flat(source, most_cut)) {
    LightDetail cut = cut_detail;
    cut.shadow_edges = &edges_;
    look(Sight::clear, cut, clear);
    look(Sight::attenuated, cut, beams);
    if (!are_unlike(clear, beams)) return;
    cut = penumbra_detail;
    cut.shadow_edges = &edges_;
    look(Sight::clear, cut, clear);
    return look(Sight::attenuated, cut, beams);
  }
  const int few = std::min(shadow_rays, few_rays);
  look(Sight::attenuated, detail_within(source, point, wall_light_detail, few, clear), beams);
  if (shadow_rays > few_rays && are_unlike(clear, beams, true))
    look(Sight::attenuated, detail_within(source, point, penumbra_detail, shadow_rays, clear), beams);
}

// Without obstacles and media the same beams come in the same order, and no rays are needed to know them.
// Behind mirrors it is not known which of them there are.
bool WallLight::are_unlike(const LightBeams& clear, const LightBeams& seen, bool hidden_too) const {
  if (!lights_.paths().mirrors().empty()) return false;
  if (hidden_too && seen.size() < clear.size()) return true;
  for (std::size_t b = 0; b < bands_; ++b) {
    double least = 1, most = 0;
    for (std::size_t i = 0, all = 0; i < seen.size() && all < clear.size(); ++all) {
      if (clear.direction(all) != seen.direction(i)) continue;
      const double part = clear.fluence(all)[b] > 0 ? seen.fluence(i)[b] / clear.fluence(all)[b] : 1;
      least = std::min(least, part);
      most = std::max(most, part);
      ++i;
    }
    if (most - least > uneven) return true;
  }
  return false;
}

}  // namespace etendue
