// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/picture/wall_light.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace etendue {
namespace {

/// Faces around a vertex lie in one plane where the cosine between them is within this of 1: what one plane
/// receives is continuous, and jumps at edges.
constexpr double flat = 1e-9;

/// Transmittances to a light that differ by more show where each ray ends.
constexpr double uneven = 0.1;

/// Parts of the area that the point cuts off with the edges.
std::array<double, 3> barycentric(const TetrahedralMesh& mesh, FaceIndex face, const Vec3& point) {
  std::array<Vec3, 3> to;
  for (std::size_t i = 0; i < 3; ++i) to[i] = mesh.point(VertexIndex(mesh.vertices(face)[i])) - point;
  const Vec3 whole = (to[1] - to[0]).cross(to[2] - to[0]);
  std::array<double, 3> part;
  for (std::size_t i = 0; i < 3; ++i)
    part[i] = to[(i + 1) % 3].cross(to[(i + 2) % 3]).dot(whole) / whole.squaredNorm();
  return part;
}

/// [vertex] the corners of boundary faces that meet there.
std::vector<std::vector<WallCorner>> corners_at_vertices(const TetrahedralMesh& mesh) {
  std::vector<std::vector<WallCorner>> corners(static_cast<std::size_t>(mesh.vertex_count()));
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
    for (std::size_t i = 0; i < 3; ++i)
      corners[static_cast<std::size_t>(mesh.vertices(FaceIndex(f))[i])].push_back({FaceIndex(f), i});
  return corners;
}

}  // namespace

std::vector<std::vector<WallCorner>> corners_by_plane(const TetrahedralMesh& mesh) {
  std::vector<std::vector<WallCorner>> planes;
  for (const std::vector<WallCorner>& corners : corners_at_vertices(mesh)) {
    const std::size_t first = planes.size();
    for (const WallCorner& corner : corners) {
      const Vec3 normal = mesh.area_normal(corner.face).normalized();
      const auto same = [&](const std::vector<WallCorner>& plane) {
        return normal.dot(mesh.area_normal(plane.front().face).normalized()) > 1 - flat;
      };
      const auto plane =
          std::find_if(planes.begin() + static_cast<std::ptrdiff_t>(first), planes.end(), same);
      if (plane == planes.end())
        planes.push_back({corner});
      else
        plane->push_back(corner);
    }
  }
  return planes;
}

WallLight::WallLight(const LightSetup& lights, const DirectionSet& directions, const SavedState& state,
                     std::size_t face_nodes)
    : lights_(lights), problem_(lights.problem()), bands_(lights.paths().bands()) {
  const TetrahedralMesh& mesh = problem_.mesh();
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
    joined_.half_range.push_back(directions.half_range(mesh.area_normal(FaceIndex(f)).normalized()));
  if (state.irradiance.size() != joined_.half_range.size() * face_nodes * bands_)
    throw InputError("the saved state is not of this kind (another mesh or other elements)");
  join(state, face_nodes);
}

// Clément (1975): the mean, weighted by area, over the faces of one plane around a vertex.
void WallLight::join(const SavedState& state, std::size_t face_nodes) {
  const TetrahedralMesh& mesh = problem_.mesh();
  joined_.values.assign(joined_.half_range.size() * 3 * bands_, 0);
  for (const std::vector<WallCorner>& plane : corners_by_plane(mesh))
    for (std::size_t b = 0; b < bands_; ++b) {
      double area = 0, sum = 0;
      for (const WallCorner& corner : plane) {
        const std::size_t node = corner.face.at() * face_nodes + (face_nodes == 3 ? corner.node : 0);
        area += mesh.area(corner.face);
        sum += mesh.area(corner.face) * state.irradiance[node * bands_ + b];
      }
      for (const WallCorner& corner : plane)
        joined_.values[(corner.face.at() * 3 + corner.node) * bands_ + b] = sum / area;
    }
}

void WallLight::add_reflected(FaceIndex face, const Vec3& point, const WallIrradiance& brought,
                              LightBeams& beams, std::span<double> radiance) const {
  const Wall& wall = problem_.wall(problem_.mesh().wall(face));
  if (std::all_of(wall.diffuse.begin(), wall.diffuse.end(), [](double value) { return value == 0; })) return;
  const Vec3 outwards = problem_.mesh().area_normal(face).normalized();
  std::vector<double> irradiance(bands_, 0);
  add_light({problem_.mesh().owner(face), point}, outwards, beams, irradiance);
  add_reflected(face, point, brought, irradiance, radiance);
}

void WallLight::add_reflected(FaceIndex face, const Vec3& point, const WallIrradiance& brought,
                              std::span<const double> irradiance, std::span<double> radiance) const {
  const Wall& wall = problem_.wall(problem_.mesh().wall(face));
  const std::array<double, 3> weights = barycentric(problem_.mesh(), face, point);
  const double half_range = brought.half_range[face.at()];
  for (std::size_t i = 0; i < 3 && half_range > 0; ++i)
    for (std::size_t b = 0; b < bands_; ++b)
      radiance[b] +=
          wall.diffuse[b] / half_range * weights[i] * brought.values[(face.at() * 3 + i) * bands_ + b];
  for (std::size_t b = 0; b < bands_; ++b)
    radiance[b] += wall.diffuse[b] * std::numbers::inv_pi * irradiance[b];
}

void WallLight::add_light(const PointInCell& point, const Vec3& normal, LightBeams& beams,
                          std::span<double> irradiance) const {
  for (const auto& source : lights_.sources()) {
    beams.clear();
    source->add_beams(point, Sight::attenuated, wall_light_detail, beams);
    if (is_penumbra(*source, point, beams)) {
      beams.clear();
      source->add_beams(point, Sight::attenuated, penumbra_detail, beams);
    }
    for (std::size_t i = 0; i < beams.size(); ++i) {
      const double cosine = std::max(0.0, normal.dot(beams.direction(i)));
      for (std::size_t b = 0; b < bands_; ++b) irradiance[b] += cosine * beams.fluence(i)[b];
    }
  }
}

// Without obstacles and media the same beams come in the same order, and no rays are needed to know them.
// Behind mirrors it is not known which of them there are.
bool WallLight::is_penumbra(const LightSource& source, const PointInCell& point,
                            const LightBeams& seen) const {
  if (source.as_wide() == nullptr || !lights_.paths().mirrors().empty()) return false;
  LightBeams clear(bands_);
  source.add_beams(point, Sight::clear, wall_light_detail, clear);
  if (seen.size() < clear.size()) return true;
  for (std::size_t b = 0; b < bands_; ++b) {
    double least = 1, most = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      const double part = clear.fluence(i)[b] > 0 ? seen.fluence(i)[b] / clear.fluence(i)[b] : 1;
      least = std::min(least, part);
      most = std::max(most, part);
    }
    if (most - least > uneven) return true;
  }
  return false;
}

}  // namespace etendue
