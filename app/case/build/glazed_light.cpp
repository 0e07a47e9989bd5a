// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/build/glazed_light.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace etendue {
namespace {

/// Normals of one flat wall differ by rounding only.
constexpr double same_normal = 1e-9;

}  // namespace

const std::vector<Glazing>* glazing_of(const Case& input, const std::string& wall) {
  for (const std::string& key : {wall, std::string("*")})
    if (const auto found = input.walls.find(key); found != input.walls.end())
      return found->second.glazing.empty() ? nullptr : &found->second.glazing;
  return nullptr;
}

std::optional<Vec3> normal_of_wall(const TetrahedralMesh& mesh, int wall) {
  std::optional<Vec3> normal;
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    if (mesh.wall(FaceIndex(f)) != wall) continue;
    const Vec3 of_face = -mesh.area_normal(FaceIndex(f)).normalized();
    if (normal && (*normal - of_face).norm() > same_normal) return {};
    normal = of_face;
  }
  return normal;
}

std::vector<EntryWalls> entry_walls(const LightCase& light, const std::vector<int>& walls, const Case& input,
                                    const TetrahedralMesh& mesh, std::vector<Fault>& faults) {
  std::vector<EntryWalls> entries;
  for (const int w : walls) {
    const std::string& name = mesh.wall_names()[static_cast<std::size_t>(w)];
    const std::vector<Glazing>* glazing = glazing_of(input, name);
    const std::optional<Vec3> normal = normal_of_wall(mesh, w);
    if (glazing != nullptr && !normal) {
      faults.push_back(fault_at(
          light.origin, "",
          fmt::format("the light \"{}\" comes in by the glazed wall {}, which is not flat; give each flat "
                      "part a name of its own",
                      light.name, name)));
      continue;
    }
    const Vec3 inwards = glazing != nullptr ? *normal : Vec3(Vec3::Zero());
    const auto alike = std::ranges::find_if(entries, [&](const EntryWalls& entry) {
      return entry.glazing == glazing && (entry.inwards - inwards).norm() < same_normal;
    });
    if (alike != entries.end())
      alike->walls.push_back(w);
    else
      entries.push_back({glazing, inwards, {w}});
  }
  return entries;
}

namespace {

/// The transmittance of a beam; of a part of a sky the mean over its width, weighted by the cosine (Gauss'
/// rule with three points in the angle of incidence).
double mean_transmittance(const Glazing& glass, double cosine, double solid_angle) {
  const double angle = std::acos(cosine), half = std::sqrt(solid_angle) / 2;
  double let_through = 0, incident = 0;
  for (const auto& [place, weight] :
       {std::pair{-0.7745966692414834, 5.0}, {0.0, 8.0}, {0.7745966692414834, 5.0}}) {
    const double falling = weight * std::max(0.0, std::cos(angle + place * half));
    let_through += falling * glass.transmittance(falling / weight);
    incident += falling;
  }
  return let_through / incident;
}

}  // namespace

std::optional<BeamLight> behind_glazing(BeamLight beam, const EntryWalls& entry) {
  beam.walls = entry.walls;
  if (entry.glazing == nullptr) return beam;
  const double cosine = std::min(1.0, beam.direction.dot(entry.inwards));
  if (cosine < least_cosine) return std::nullopt;
  for (std::size_t b = 0; b < beam.irradiance.size(); ++b)
    beam.irradiance[b] *= mean_transmittance((*entry.glazing)[b], cosine, beam.solid_angle);
  return beam;
}

}  // namespace etendue
