// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/rays/mirror_copies.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace etendue {
namespace {

constexpr std::size_t most_copies = 4096;
/// Part of a beam's direction that leads out from between all parallel mirrors, below which it never leaves.
constexpr double least_way_out = 1e-3;
/// Distance below which parallel mirrors are in one plane [length].
constexpr double one_mirror_plane = 1e-9;

MirrorCopy reflection(const MirrorPlanes& planes, int plane) {
  const Vec3& normal = planes.normal(plane);
  return {Eigen::Matrix3d::Identity() - 2 * normal * normal.transpose(), 2 * planes.offset(plane) * normal};
}

MirrorCopy after(const MirrorCopy& first, const MirrorCopy& second) {
  return {second.turn * first.turn, second.turn * first.shift + second.shift};
}

/// Each of the copies by each of the ways.
void multiply(std::vector<MirrorCopy>& copies, const std::vector<MirrorCopy>& ways) {
  std::vector<MirrorCopy> all;
  for (const MirrorCopy& way : ways)
    for (const MirrorCopy& copy : copies) all.push_back(after(copy, way));
  copies = std::move(all);
}

double extent(const TetrahedralMesh& mesh, const Vec3& along) {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const Vec3& point : mesh.points()) {
    least = std::min(least, along.dot(point));
    most = std::max(most, along.dot(point));
  }
  return most - least;
}

double distance(const MirrorPlanes& planes, int a, int b) {
  return after(reflection(planes, a), reflection(planes, b)).shift.norm() / 2;
}

/// Images of a pair of parallel mirrors: the room moved by twice their distance any number of times, and its
/// image so.
std::vector<MirrorCopy> between(const MirrorPlanes& planes, int first, int second, int times) {
  const Vec3 step = after(reflection(planes, first), reflection(planes, second)).shift;
  std::vector<MirrorCopy> ways;
  for (int k = -times; k <= times; ++k)
    for (MirrorCopy way : {MirrorCopy{}, reflection(planes, first)}) {
      way.shift += k * step;
      ways.push_back(way);
    }
  return ways;
}

}  // namespace

std::vector<MirrorCopy> copies_behind(const MirrorPlanes& planes, MirrorSet mirrors) {
  std::vector<MirrorCopy> copies(1);
  for (int i = 0; i < planes.count(); ++i)
    if ((mirrors >> i & 1) != 0) multiply(copies, {MirrorCopy{}, reflection(planes, i)});
  return copies;
}

std::vector<MirrorCopy> copies_along(const LightPaths& paths, MirrorSet mirrors, const Vec3& direction) {
  const MirrorPlanes& planes = paths.mirrors();
  std::vector<std::pair<int, int>> pairs;
  MirrorSet alone = mirrors;
  Vec3 out = direction;
  for (int i = 0; i < planes.count(); ++i)
    for (int j = 0; j < i; ++j) {
      // The two sides of one sheet never see each other.
      if (!planes.are_parallel(i, j) || distance(planes, i, j) < one_mirror_plane) continue;
      pairs.emplace_back(j, i);
      alone &= ~(MirrorSet{1} << i) & ~(MirrorSet{1} << j);
      out -= out.dot(planes.normal(i)) * planes.normal(i);
    }
  std::vector<MirrorCopy> copies = copies_behind(planes, alone);
  if (pairs.empty()) return copies;
  if (out.norm() < least_way_out) return {};
  const TetrahedralMesh& mesh = paths.problem().mesh();
  const double way = static_cast<double>(copies.size()) * extent(mesh, out.normalized()) / out.norm();
  for (const auto& [first, second] : pairs) {
    const Vec3& normal = planes.normal(first);
    const double times =
        std::ceil(way * std::abs(direction.dot(normal)) / (2 * distance(planes, first, second))) + 1;
    // Three in parallel show more than pairs do.
    if (!(4 * times * static_cast<double>(copies.size()) < most_copies) || pairs.size() > 2) return {};
    multiply(copies, between(planes, first, second, static_cast<int>(times)));
  }
  return copies;
}

}  // namespace etendue
