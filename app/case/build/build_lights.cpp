// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/build/build_lights.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>

#include "app/case/build/glazed_light.h"
#include "app/case/build/open_walls.h"
#include "app/case/build/round_beam.h"
#include "app/case/build/sky_parts.h"
#include "app/case/fibre.h"
#include "app/case/point_light.h"
#include "mesh/tetrahedra/search/cell_locator.h"
#include "mesh/tetrahedra/search/outer_walls.h"
#include "solver/problem/lights/lamp_in_cone.h"
#include "solver/problem/lights/lamp_shape.h"
#include "solver/problem/mirror.h"

namespace etendue {
namespace {

using std::numbers::pi;

constexpr int sides_of_a_disc = 64;

/// The walls that a light names, else the open ones.
std::vector<int> walls_of(const LightCase& light, const std::vector<Wall>& walls,
                          const TetrahedralMesh& mesh) {
  if (light.walls.empty()) return open_walls(mesh, walls);
  std::vector<int> numbers;
  for (std::size_t w = 0; w < walls.size(); ++w)
    if (std::ranges::count(light.walls, walls[w].name) > 0) numbers.push_back(static_cast<int>(w));
  return numbers;
}

// A regular polygon of the disc's area, counterclockwise from where it shines to.
SurfaceLight disc_light(const LightCase& light) {
  const Vec3 u = light.direction.unitOrthogonal(), v = light.direction.cross(u);
  const double step = 2 * pi / sides_of_a_disc;
  const double radius = light.radius * std::sqrt(step / std::sin(step));
  const auto rim = [&](int i) {
    return Vec3(light.position + radius * (std::cos(i * step) * u + std::sin(i * step) * v));
  };
  SurfaceLight surface{{}, values_of(light.strength)};
  for (int i = 0; i < sides_of_a_disc; ++i)
    for (const Vec3& corner : {light.position, rim(i), rim(i + 1)}) surface.triangles.push_back(corner);
  return surface;
}

SurfaceLight rectangle_light(const LightCase& light) {
  const Vec3 across = light.direction.cross(light.along).normalized();
  const Vec3 u = across.cross(light.direction) * light.size[0] / 2, v = across * light.size[1] / 2;
  const Vec3& p = light.position;
  const Vec3 a = p - u - v, b = p + u - v, c = p + u + v, d = p - u + v;
  return {{a, b, c, a, c, d}, values_of(light.strength)};
}

void require_inside(const LightCase& light, std::span<const Vec3> points, const CellLocator& locator,
                    std::vector<Fault>& faults) {
  for (const Vec3& point : points)
    if (locator.find(point).empty())
      return faults.push_back(fault_at(
          light.origin, "",
          fmt::format("the light \"{}\" reaches out of the mesh at [{}, {}, {}]; move it into a region",
                      light.name, point.x(), point.y(), point.z())));
}

/// Part of its own shape that a lamp has to send into the domain.
constexpr double least_part_inside = 1e-6;

/// Part of a lamp's light that leads into the domain; below 1 where the lamp lies on a wall.
double part_inside(const PointLight& point, const CellLocator& locator, const TetrahedralMesh& mesh) {
  const std::vector<CellPoint> cells = locator.find(point.position);
  if (cells.empty()) return 1;
  return integral_of_lamp_shape(point, TangentCone(mesh, cells)) / integral_of_lamp_shape(point);
}

/// A lamp on a wall must not shine at the wall alone.
PointLight lamp(const LightCase& light, const CellLocator& locator, const TetrahedralMesh& mesh,
                std::vector<Fault>& faults) {
  PointLight point = point_light(light);
  const double inside = part_inside(point, locator, mesh);
  if (inside <= least_part_inside)
    faults.push_back(
        fault_at(light.origin, "",
                 fmt::format("the light \"{}\" on a wall shines only at the wall (its power has to "
                             "go into the domain); turn it, or move it into a region",
                             light.name)));
  // The solver sends all of a lamp's power into the domain.
  if (light.keeps_intensity)
    for (double& power : point.power) power *= inside;
  return point;
}

/// A wall that lets light in must not mirror: what comes through would be turned back there.
void require_open(const LightCase& light, const std::vector<int>& numbers, const std::vector<Wall>& walls,
                  std::vector<Fault>& faults) {
  if (numbers.empty())
    faults.push_back(
        fault_at(light.origin, "",
                 fmt::format("no wall lets the light \"{}\" in (all outer ones shine or reflect); "
                             "name walls",
                             light.name)));
  for (const int w : numbers)
    for (const double specular : walls[static_cast<std::size_t>(w)].specular)
      if (specular > 0)
        return faults.push_back(fault_at(
            light.origin, "",
            fmt::format(
                "the light \"{}\" comes in by the mirror {} (it would be turned back there); make the "
                "wall black or diffuse",
                light.name, walls[static_cast<std::size_t>(w)].name)));
}

/// A beam must come in by one of its walls.
void require_incoming(const LightCase& light, const std::vector<int>& numbers, const TetrahedralMesh& mesh,
                      std::vector<Fault>& faults) {
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
    if (const FaceIndex face(f);
        std::ranges::count(numbers, mesh.wall(face)) > 0 &&
        -light.direction.dot(mesh.area_normal(face)) > least_cosine * mesh.area(face))
      return;
  if (numbers.empty()) return;
  faults.push_back(fault_at(
      light.origin, "",
      fmt::format("the light \"{}\" comes in by none of its walls (it travels along [{:.4g}, {:.4g}, "
                  "{:.4g}], out of the domain or along them); turn it, or name other walls",
                  light.name, light.direction.x(), light.direction.y(), light.direction.z())));
}

Vec3 point_of(const TetrahedralMesh& mesh, int wall) {
  std::int32_t f = 0;
  while (mesh.wall(FaceIndex(f)) != wall) ++f;
  return mesh.point(VertexIndex(mesh.vertices(FaceIndex(f))[0]));
}

/// Light of a beam behind a smooth surface: Snell's law, and the irradiance across it that is left.
BeamLight refracted(const BeamLight& beam, const Vec3& normal, double index) {
  const double cosine = beam.direction.dot(normal);
  const double cosine_behind = std::sqrt(std::max(0.0, 1 - (1 - cosine * cosine) / (index * index)));
  const double part = (1 - fresnel_reflectance(cosine, 1 / index)) * cosine;
  BeamLight inside = beam;
  inside.direction = (beam.direction / index + (cosine_behind - cosine / index) * normal).normalized();
  for (double& irradiance : inside.irradiance) irradiance *= part > 0 ? part / cosine_behind : 0;
  return inside;
}

/// The walls that a beam can meet from outside.
std::vector<int> walls_facing(const Vec3& direction, const std::vector<int>& walls,
                              const TetrahedralMesh& mesh) {
  std::vector<int> facing;
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const int wall = mesh.wall(FaceIndex(f));
    const Vec3& outwards = mesh.area_normal(FaceIndex(f));
    if (-outwards.dot(direction) > least_cosine * outwards.norm() && std::ranges::count(walls, wall) > 0 &&
        std::ranges::count(facing, wall) == 0)
      facing.push_back(wall);
  }
  return facing;
}

/// A beam behind the walls by which it comes in.
BeamLight beam_inside(const LightCase& light, const BeamLight& beam, const std::vector<Wall>& walls,
                      const TetrahedralMesh& mesh, std::vector<Fault>& faults) {
  const std::vector<int> numbers =
      light.walls.empty() ? walls_facing(beam.direction, beam.walls, mesh) : beam.walls;
  const auto refracts = [&](int w) { return walls[static_cast<std::size_t>(w)].refractive_index != 1; };
  const auto first = std::ranges::find_if(numbers, refracts);
  if (first == numbers.end()) return beam;
  const std::string& name = walls[static_cast<std::size_t>(*first)].name;
  const std::optional<Vec3> normal = normal_of_wall(mesh, *first);
  if (numbers.size() == 1 && normal && beam.direction.dot(*normal) > 0) {
    BeamLight inside = refracted(beam, *normal, walls[static_cast<std::size_t>(*first)].refractive_index);
    inside.walls = numbers;
    if (beam.profile) refract_profile(beam.direction, *normal, point_of(mesh, *first), inside);
    return inside;
  }
  faults.push_back(
      fault_at(light.origin, "",
               fmt::format("the light \"{}\" comes in by the wall {}, which refracts, {}", light.name, name,
                           numbers.size() > 1 ? "and by others; name one wall for each light"
                           : !normal ? "and is not flat; give each flat part a name and a light of its own"
                                     : "from behind; turn the light, or name another wall")));
  return beam;
}

/// The light of a sun or a beam before the walls by which it comes in.
std::vector<BeamLight> beams_outside(const LightCase& light, const std::vector<int>& numbers) {
  BeamLight beam{light.direction, values_of(light.strength), numbers};
  if (light.kind == LightKind::beam) shape_beam(light, beam);
  if (light.numerical_aperture > 0 && beam.profile) return fibre_parts(beam, light.numerical_aperture);
  return {beam};
}

/// Name of the light that comes in by some of its walls: lights in a row that have one name are
/// taken for one sky.
std::string name_by(const LightCase& light, const EntryWalls& entry, const TetrahedralMesh& mesh) {
  if (entry.glazing == nullptr) return light.name;
  return light.name + " through " + mesh.wall_names()[static_cast<std::size_t>(entry.walls.front())];
}

std::vector<Light> beams_of_sun(const LightCase& light, const std::vector<EntryWalls>& entries,
                                const std::vector<Wall>& walls, const TetrahedralMesh& mesh,
                                std::vector<Fault>& faults) {
  std::vector<Light> beams;
  for (const EntryWalls& entry : entries) {
    for (const BeamLight& outside : beams_outside(light, entry.walls)) {
      const std::size_t before = faults.size();
      if (auto beam = behind_glazing(beam_inside(light, outside, walls, mesh, faults), entry))
        beams.push_back({name_by(light, entry, mesh), *std::move(beam), light.origin, light.uncollided});
      if (faults.size() > before) break;
    }
  }
  return beams;
}

std::vector<Light> parts_of_sky(const LightCase& light, const EntryWalls& entry,
                                const TetrahedralMesh& mesh) {
  std::vector<Light> sky;
  for (const BeamLight& part : light.angle.empty() ? even_sky_parts(light, entry.inwards, entry.walls)
                                                   : sky_parts(light, entry.walls))
    if (auto beam = behind_glazing(part, entry))
      sky.push_back({name_by(light, entry, mesh), *std::move(beam), light.origin, light.uncollided});
  return sky;
}

void require_no_glazing(const LightCase& light, const Case& input, std::vector<Fault>& faults) {
  for (const std::string& wall : light.walls)
    if (glazing_of(input, wall) != nullptr)
      return faults.push_back(fault_at(
          light.origin, "",
          fmt::format("the light \"{}\" shines from the glazed wall {}; use kind \"sky\" for light that "
                      "comes in by glazing",
                      light.name, wall)));
}

/// By a wall of a body or a sheet in the domain no light comes in.
void require_outer_glazing(const Case& input, const TetrahedralMesh& mesh, std::vector<Fault>& faults) {
  const std::vector<bool> outer = outer_walls(mesh);
  for (std::size_t w = 0; w < outer.size(); ++w) {
    const std::string& name = mesh.wall_names()[w];
    const auto entry = input.walls.find(name);
    if (outer[w] || entry == input.walls.end() || entry->second.glazing.empty()) continue;
    faults.push_back(
        fault_at(entry->second.origin, "",
                 "glazing in a wall that is no outer one; use it where light from outside comes in, "
                 "and transmittance for sheets"));
  }
}

/// The heat of such a wall is that of all light which meets it or leaves it.
void require_no_following(const LightCase& light, const std::vector<int>& numbers,
                          const std::vector<Wall>& walls, std::vector<Fault>& faults) {
  for (const int w : numbers)
    if (const Wall& wall = walls[static_cast<std::size_t>(w)]; wall.emission_follows)
      return faults.push_back(fault_at(
          light.origin, "",
          fmt::format(
              "the light \"{}\" comes from the wall {}, whose temperature follows from its heat (not in "
              "this version); give the wall a temperature, or the light another one",
              light.name, wall.name)));
}

void shine(const LightCase& light, const std::vector<int>& numbers, std::vector<Wall>& walls,
           std::vector<Fault>& faults) {
  for (const int w : numbers) {
    Wall& wall = walls[static_cast<std::size_t>(w)];
    if (std::ranges::any_of(wall.radiance, [](double v) { return v > 0; })) {
      faults.push_back(
          fault_at(light.origin, "",
                   fmt::format("the wall {} of the light \"{}\" has a radiance already; give one "
                               "of them",
                               wall.name, light.name)));
      continue;
    }
    wall.radiance = values_of(light.strength);
    // A uniform sky of radiance L sends pi L to a level plane.
    if (std::holds_alternative<IrradianceOfLight>(light.strength))
      for (double& radiance : wall.radiance) radiance /= pi;
    wall.uncollided = light.uncollided == Uncollided::no ? Uncollided::no : Uncollided::yes;
  }
}

}  // namespace

std::vector<Light> build_lights(const Case& input, const TetrahedralMesh& mesh, std::vector<Wall>& walls) {
  std::vector<Light> lights, skies;
  std::vector<Fault> faults;
  if (input.lights.empty()) return lights;
  require_outer_glazing(input, mesh, faults);
  const CellLocator locator(mesh);
  const std::vector<Wall> as_written = walls;
  for (const LightCase& light : input.lights) {
    const bool by_walls = light.kind == LightKind::sun || light.kind == LightKind::beam ||
                          light.kind == LightKind::sky || light.kind == LightKind::wall;
    const std::vector<int> numbers = by_walls ? walls_of(light, as_written, mesh) : std::vector<int>{};
    require_no_following(light, numbers, as_written, faults);
    if (light.kind == LightKind::point || light.kind == LightKind::spot) {
      require_inside(light, std::span(&light.position, 1), locator, faults);
      lights.push_back({light.name, lamp(light, locator, mesh, faults), light.origin, light.uncollided});
    } else if (light.kind == LightKind::sun || light.kind == LightKind::beam) {
      const std::size_t before = faults.size();
      require_open(light, numbers, as_written, faults);
      std::vector<Light> beams =
          beams_of_sun(light, entry_walls(light, numbers, input, mesh, faults), as_written, mesh, faults);
      if (faults.size() == before) require_incoming(light, numbers, mesh, faults);
      if (faults.size() == before && light.kind == LightKind::beam)
        require_hit(light, beams, locator, mesh, faults);
      std::ranges::move(beams, std::back_inserter(lights));
    } else if (light.kind == LightKind::sky) {
      for (const EntryWalls& entry : entry_walls(light, numbers, input, mesh, faults)) {
        if (entry.glazing == nullptr && light.angle.empty()) {
          shine(light, entry.walls, walls, faults);
          continue;
        }
        require_open(light, entry.walls, as_written, faults);
        std::ranges::move(parts_of_sky(light, entry, mesh), std::back_inserter(skies));
      }
    } else if (light.kind == LightKind::wall) {
      require_no_glazing(light, input, faults);
      shine(light, numbers, walls, faults);
    } else {
      SurfaceLight surface = light.kind == LightKind::disc ? disc_light(light) : rectangle_light(light);
      require_inside(light, surface.triangles, locator, faults);
      lights.push_back({light.name, std::move(surface), light.origin, light.uncollided});
    }
  }
  if (!faults.empty()) throw InputError(std::move(faults));
  std::ranges::move(skies, std::back_inserter(lights));
  return lights;
}

}  // namespace etendue
