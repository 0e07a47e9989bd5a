// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/rays/mirror_images.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace etendue {
namespace {

/// Normals, and offsets over the size of the domain, that agree to this are those of one plane.
constexpr double same_mirror_plane = 1e-9;

double size_of(const TetrahedralMesh& mesh) {
  double size = 0;
  for (const Vec3& point : mesh.points()) size = std::max(size, (point - mesh.points().front()).norm());
  return size;
}

bool mirrors(const Wall& wall) {
  return std::any_of(wall.specular.begin(), wall.specular.end(), [](double r) { return r > 0; });
}

Fault refusal(const Wall& wall, const std::string& other, const std::string& why) {
  Origin origin = wall.origin;
  origin.key += ".specular";
  return fault_at(
      origin, "",
      fmt::format("with the mirror {} this one {} (uncollided light follows mirrors only on planes "
                  "at right angles); use diffuse reflectance, or uncollided = false",
                  other, why));
}

}  // namespace

MirrorPlanes::MirrorPlanes(const Problem& problem) : problem_(problem) {
  const TetrahedralMesh& mesh = problem.mesh();
  const double size = size_of(mesh);
  of_face_.assign(static_cast<std::size_t>(mesh.boundary_face_count()), -1);
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    if (!mirrors(problem.wall(mesh.wall(face)))) continue;
    const Vec3 normal = mesh.area_normal(face).normalized();
    const double offset = normal.dot(mesh.centroid(face));
    const auto same = [&](const Plane& plane) {
      return (plane.normal - normal).norm() < same_mirror_plane &&
             std::abs(plane.offset - offset) < same_mirror_plane * size;
    };
    auto plane = std::find_if(planes_.begin(), planes_.end(), same);
    if (plane == planes_.end()) plane = planes_.insert(planes_.end(), {normal, offset, mesh.wall(face)});
    of_face_[face.at()] = static_cast<int>(plane - planes_.begin());
  }
}

Vec3 MirrorPlanes::reflected(int plane, const Vec3& direction) const {
  const Vec3& normal = planes_[static_cast<std::size_t>(plane)].normal;
  return direction - 2 * direction.dot(normal) * normal;
}

bool MirrorPlanes::are_parallel(int a, int b) const {
  return std::abs(normal(a).dot(normal(b))) > 1 - same_mirror_plane;
}

bool MirrorPlanes::touches(MirrorSet set, const Vec3& point, double distance) const {
  for (std::size_t i = 0; i < planes_.size(); ++i)
    if ((set >> i & 1) != 0 && std::abs(planes_[i].normal.dot(point) - planes_[i].offset) > distance)
      return false;
  return true;
}

MirrorSet MirrorPlanes::behind(MirrorSet set, const Vec3& point, double distance) const {
  MirrorSet found = 0;
  for (std::size_t i = 0; i < planes_.size(); ++i)
    if ((set >> i & 1) != 0 && planes_[i].normal.dot(point) - planes_[i].offset > distance)
      found |= MirrorSet{1} << i;
  return found;
}

Vec3 MirrorPlanes::image(MirrorSet set, Vec3 point) const {
  for (std::size_t i = 0; i < planes_.size(); ++i)
    if ((set >> i & 1) != 0)
      point -= 2 * (planes_[i].normal.dot(point) - planes_[i].offset) * planes_[i].normal;
  return point;
}

Vec3 MirrorPlanes::image_direction(MirrorSet set, Vec3 direction) const {
  for (std::size_t i = 0; i < planes_.size(); ++i)
    if ((set >> i & 1) != 0) direction = reflected(static_cast<int>(i), direction);
  return direction;
}

double MirrorPlanes::reflectance(MirrorSet set, std::size_t band) const {
  double product = 1;
  for (std::size_t i = 0; i < planes_.size(); ++i)
    if ((set >> i & 1) != 0) product *= problem_.wall(planes_[i].wall).specular[band];
  return product;
}

void MirrorPlanes::require_right_angle(const Plane& a, const Plane& b) const {
  const double cosine = a.normal.dot(b.normal);
  if (std::abs(cosine) < same_mirror_plane) return;
  const bool parallel = std::abs(cosine) > 1 - same_mirror_plane;
  throw InputError(
      refusal(problem_.wall(a.wall), problem_.wall(b.wall).name,
              parallel ? "shows a light again and again" : "stands at an angle that is not 90 degrees"));
}

void MirrorPlanes::require_one_image_per_direction(const Vec3& direction) const {
  const auto meets = [&](const Plane& plane) {
    return std::abs(plane.normal.dot(direction)) > same_mirror_plane;
  };
  for (std::size_t i = 0; i < planes_.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (meets(planes_[i]) && meets(planes_[j])) require_right_angle(planes_[i], planes_[j]);
}

std::vector<MirrorSet> MirrorPlanes::images_of_point() const {
  for (std::size_t i = 0; i < planes_.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) require_right_angle(planes_[i], planes_[j]);
  std::vector<MirrorSet> sets(std::size_t{1} << planes_.size());
  for (std::size_t i = 0; i < sets.size(); ++i) sets[i] = static_cast<MirrorSet>(i);
  return sets;
}

std::vector<MirrorSet> MirrorPlanes::images_of_direction() const {
  std::vector<std::size_t> different;
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    bool repeated = false;
    for (const std::size_t j : different) {
      const double cosine = std::abs(planes_[i].normal.dot(planes_[j].normal));
      repeated = repeated || cosine > 1 - same_mirror_plane;
      if (cosine > same_mirror_plane && cosine <= 1 - same_mirror_plane)
        throw InputError(refusal(problem_.wall(planes_[i].wall), problem_.wall(planes_[j].wall).name,
                                 "stands at an angle that is neither 0 nor 90 degrees"));
    }
    if (!repeated) different.push_back(i);
  }
  std::vector<MirrorSet> sets = {0};
  for (const std::size_t plane : different)
    for (std::size_t i = 0, n = sets.size(); i < n; ++i) sets.push_back(sets[i] | MirrorSet{1} << plane);
  return sets;
}

}  // namespace etendue
