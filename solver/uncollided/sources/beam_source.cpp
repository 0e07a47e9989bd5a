// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/sources/beam_source.h"

#include <algorithm>

#include "solver/problem/lights/beam_pieces.h"

namespace etendue {
namespace {

/// Power that enters: the irradiance times the area of the walls as the beam sees it.
std::vector<double> beam_power(const BeamLight& light, const TetrahedralMesh& mesh) {
  double area = 0;
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
    if (std::count(light.walls.begin(), light.walls.end(), mesh.wall(FaceIndex(f))) > 0)
      area += entering_area(light, mesh, FaceIndex(f));
  std::vector<double> power = light.irradiance;
  for (double& value : power) value *= area;
  return power;
}

/// The cross-section of a beam as mirrors show it.
std::optional<BeamProfile> image_of(const std::optional<BeamProfile>& profile, const MirrorPlanes& planes,
                                    MirrorSet mirrors) {
  if (!profile) return {};
  BeamProfile image = *profile;
  image.center = planes.image(mirrors, profile->center);
  image.across = planes.image_direction(mirrors, profile->across);
  image.upright = planes.image_direction(mirrors, profile->upright);
  return image;
}

}  // namespace

BeamSource::BeamSource(std::string name, const BeamLight& light, const LightPaths& paths)
    : LightSource(std::move(name), beam_power(light, paths.problem().mesh())), light_(light), paths_(paths) {
  for (const MirrorSet mirrors : paths.mirrors().images_of_direction()) {
    const Vec3 direction = paths.mirrors().image_direction(mirrors, light.direction);
    // A beam along a mirror is its own image.
    const auto same = [&](const Vec3& other) { return (other - direction).norm() < returning_direction; };
    if (std::ranges::any_of(directions_, same)) continue;
    directions_.push_back(direction);
    mirrors_.push_back(mirrors);
    profiles_.push_back(image_of(light.profile, paths.mirrors(), mirrors));
  }
}

bool BeamSource::arrives(const PointInCell& at, const Vec3& direction, std::span<double> fluence) const {
  const std::optional<WayOut> out = paths_.leave(at, -direction, fluence);
  if (!out || !((out->direction + light_.direction).norm() < returning_direction) ||
      std::ranges::count(light_.walls, paths_.problem().mesh().wall(out->face)) == 0)
    return false;
  const double part = part_on_ray(light_.profile, out->point);
  for (std::size_t b = 0; b < fluence.size(); ++b) fluence[b] *= part * light_.irradiance[b];
  return part > 0;
}

double BeamSource::part_on_ray(const std::optional<BeamProfile>& profile, const Vec3& point) {
  return profile ? relative_irradiance(*profile, point) : 1;
}

void BeamSource::add_beam(std::size_t image, const PointInCell& at, Sight sight, LightBeams& beams) const {
  const std::span<double> fluence = beams.add(directions_[image]);
  if (sight == Sight::clear) {
    const double part = part_on_ray(profiles_[image], at.position);
    for (std::size_t b = 0; b < fluence.size(); ++b) fluence[b] = part * light_.irradiance[b];
    if (part == 0) beams.drop();
  } else if (!arrives(at, directions_[image], fluence)) {
    beams.drop();
  }
}

void BeamSource::add_beams(const PointInCell& at, Sight sight, LightDetail, LightBeams& beams) const {
  for (std::size_t i = 0; i < directions_.size(); ++i) add_beam(i, at, sight, beams);
}

std::vector<std::array<Vec3, 3>> BeamSource::lit_parts(std::size_t image,
                                                       const std::array<Vec3, 3>& triangle) const {
  return profiles_[image] ? beam_pieces(*profiles_[image], triangle) : std::vector{triangle};
}

double BeamSource::part_of_cell(double size) const {
  if (!light_.profile) return 1;
  return std::min(1.0, 1 / (light_.profile->across.squaredNorm() * size * size));
}

}  // namespace etendue
