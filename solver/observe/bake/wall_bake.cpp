// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/bake/wall_bake.h"

#include <algorithm>
#include <numbers>

#include "base/field_view.h"
#include "base/parallel/parallel_for.h"
#include "mesh/tetrahedra/corners.h"
#include "solver/observe/camera/gather.h"
#include "solver/uncollided/lights/light_irradiance.h"

namespace etendue {
namespace {

using std::numbers::pi;

/// [place][band]; empty where it was stopped.
std::vector<double> light_at(const std::vector<BakePlace>& places, const LightSetup& lights, int threads,
                             const StageObserver& observer) {
  const TetrahedralMesh& mesh = lights.problem().mesh();
  const std::size_t bands = lights.paths().bands();
  std::vector<double> values(places.size() * bands);
  const LightIrradiance direct(lights);
  StageCounter counter(places.size(), observer);
  const bool whole = parallel_for(places.size(), threads, 4, [&](std::size_t i) {
    const BakePlace& place = places[i];
    const UncollidedAtPoint light =
        direct.at({mesh.owner(place.face), place.position}, -mesh.area_normal(place.face).normalized());
    std::copy(light.irradiance.begin(), light.irradiance.end(),
              values.begin() + static_cast<std::ptrdiff_t>(i * bands));
    return counter.add();
  });
  if (!whole) values.clear();
  return values;
}

}  // namespace

WallSurface wall_surface(const TetrahedralMesh& mesh) {
  WallSurface surface;
  surface.triangles.resize(static_cast<std::size_t>(mesh.boundary_face_count()));
  for (const std::vector<WallCorner>& plane : corners_by_plane(mesh)) {
    const WallCorner& first = plane.front();
    for (const WallCorner& corner : plane)
      surface.triangles[corner.face.at()][corner.node] = static_cast<std::int32_t>(surface.vertices.size());
    surface.vertices.push_back(
        {corner_of(mesh, first.face, first.node), -mesh.area_normal(first.face).normalized(), first});
  }
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const auto [a, b, c] = corners_of(mesh, FaceIndex(f));
    auto& triangle = surface.triangles[static_cast<std::size_t>(f)];
    if ((b - a).cross(c - a).dot(mesh.area_normal(FaceIndex(f))) > 0) std::swap(triangle[1], triangle[2]);
  }
  return surface;
}

std::vector<BakePlace> vertex_places(const WallSurface& surface, const TetrahedralMesh& mesh) {
  std::vector<BakePlace> places;
  for (const WallSurface::Vertex& vertex : surface.vertices) {
    BakePlace place{vertex.corner.face, {0, 0, 0}, {}};
    place.weights[vertex.corner.node] = 1;
    place.position = vertex.position + off_the_vertex * (mesh.centroid(place.face) - vertex.position);
    places.push_back(place);
  }
  return places;
}

std::vector<double> bake_irradiance(const std::vector<BakePlace>& places, const LightSetup& lights,
                                    const WallIrradiance& brought, int threads,
                                    const StageObserver& observer) {
  const std::size_t bands = lights.paths().bands();
  std::vector<double> values(places.size() * bands, 0);
  if (!lights.empty()) values = light_at(places, lights, threads, observer);
  if (values.empty()) return values;
  const BandTable irradiance(values, bands);
  const ConstFaceField added(brought.values, bands);
  for (std::size_t p = 0; p < places.size(); ++p)
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t b = 0; b < bands; ++b)
        irradiance(p, b) += places[p].weights[i] * added(places[p].face, i, b);
  return values;
}

std::vector<double> bake_radiosity(const std::vector<BakePlace>& places, const Problem& problem,
                                   const std::vector<double>& irradiance) {
  const auto bands = static_cast<std::size_t>(problem.band_count());
  std::vector<double> values(irradiance.size());
  for (std::size_t p = 0; p < places.size(); ++p) {
    const Wall& wall = problem.wall(problem.mesh().wall(places[p].face));
    for (std::size_t b = 0; b < bands; ++b) {
      double& value = values[p * bands + b];
      value = wall.diffuse[b] * irradiance[p * bands + b] + pi * wall.radiance[b];
      for (std::size_t i = 0; i < 3; ++i)
        value +=
            pi * places[p].weights[i] * problem.following_radiance(places[p].face, i, static_cast<int>(b));
    }
  }
  return values;
}

std::vector<double> bake_sky_visibility(const std::vector<BakePlace>& places, const TetrahedralMesh& mesh,
                                        const std::vector<int>& sky, int threads,
                                        const StageObserver& observer) {
  std::vector<Medium> media;
  for (const std::string& name : mesh.region_names())
    media.push_back(
        {name, {Coefficient(0.0)}, {Coefficient(0.0)}, {Coefficient(0.0)}, {PhaseIsotropic{}}, {}});
  std::vector<Wall> walls;
  for (std::size_t w = 0; w < mesh.wall_names().size(); ++w) {
    const bool shines = std::ranges::count(sky, static_cast<int>(w)) > 0;
    walls.push_back({mesh.wall_names()[w], {shines ? 1.0 : 0.0}, {0.0}, {0.0}, {}, Uncollided::yes});
  }
  const Problem outdoors(mesh, {}, media, walls);
  const LightSetup lights(outdoors);
  std::vector<double> values = light_at(places, lights, threads, observer);
  for (double& value : values) value /= pi;
  return values;
}

}  // namespace etendue
