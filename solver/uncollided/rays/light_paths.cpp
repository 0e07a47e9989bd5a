// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/rays/light_paths.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "base/vector_sums.h"

namespace etendue {
namespace {

/// A wall that stands this part of the path before its end is where the light is.
constexpr double end_of_path = 1e-9;
/// Mirrors on one path after which it is given up: nothing that counts comes from there.
constexpr int most_reflections = 10000;

std::vector<double> extinction_of(const Problem& problem, std::span<const double> added) {
  std::vector<double> extinction(problem.absorption().begin(), problem.absorption().end());
  add_to(extinction, problem.scattering());
  if (!added.empty()) add_to(extinction, added);
  return extinction;
}

/// [cell] The numbers of media of constant extinction: one for each value [band].
std::vector<std::int32_t> constant_media(const Problem& problem, const RayMatter& matter,
                                         std::span<const double> extinction) {
  const TetrahedralMesh& mesh = problem.mesh();
  const auto bands = static_cast<std::size_t>(problem.band_count());
  const auto values_of = [&](std::size_t cell) { return extinction.subspan(cell * bands, bands); };
  constexpr std::size_t no_cell = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> first(mesh.region_names().size(), no_cell);  // cell of a region
  std::vector<char> constant(first.size(), 1);
  for (std::size_t c = 0; c < static_cast<std::size_t>(mesh.cell_count()); ++c) {
    const int number = mesh.region(CellIndex(static_cast<std::int64_t>(c)));
    const auto region = static_cast<std::size_t>(number);
    if (first[region] == no_cell) first[region] = c;
    const bool alike = !matter.varies(CellIndex(static_cast<std::int64_t>(c))) &&
                       !matter.depends_on_direction(number) &&
                       std::ranges::equal(values_of(c), values_of(first[region]));
    constant[region] = constant[region] != 0 && alike ? 1 : 0;
  }
  std::vector<std::int32_t> of_region(first.size(), MediumSurfaces::varying);
  std::map<std::vector<double>, std::int32_t> numbers;
  for (std::size_t r = 0; r < first.size(); ++r) {
    if (first[r] == no_cell || constant[r] == 0) continue;
    const std::span<const double> values = values_of(first[r]);
    const auto region = static_cast<std::int32_t>(r);
    of_region[r] = numbers.try_emplace({values.begin(), values.end()}, region).first->second;
  }
  std::vector<std::int32_t> media;
  for (const std::int32_t region : mesh.cell_regions())
    media.push_back(of_region[static_cast<std::size_t>(region)]);
  return media;
}

}  // namespace

LightPaths::LightPaths(const Problem& problem, std::vector<double> added)
    : problem_(problem),
      bands_(static_cast<std::size_t>(problem.band_count())),
      rays_(problem.mesh()),
      mirrors_(problem),
      matter_(problem),
      added_(std::move(added)),
      extinction_(extinction_of(problem, added_)),
      surfaces_(problem.mesh(), constant_media(problem, matter_, extinction_), mirrors_.count() > 0) {}

double LightPaths::largest_extinction(CellIndex cell) const {
  const auto first = extinction_.begin() + static_cast<std::ptrdiff_t>(cell.at() * bands_);
  return *std::max_element(first, first + static_cast<std::ptrdiff_t>(bands_));
}

template <class Condition>
RayMesh::PartOfPath LightPaths::walk_while(const PointInCell& from, const Vec3& direction, double length,
                                           std::span<double> depth, const RayMatter::View& light,
                                           const Condition& enter) const {
  if (!matter_.empty()) {
    double reached = 0;
    const auto add = [&](CellIndex cell, double part) {
      if (!matter_.varies(cell) && !matter_.depends_on_direction(problem_.mesh().region(cell))) {
        const double* extinction = &extinction_[cell.at() * bands_];
        for (std::size_t b = 0; b < bands_; ++b) depth[b] += extinction[b] * part;
      } else {
        // What is linear has its mean in the middle.
        const Vec3 middle = from.position + (reached + part / 2) * direction;
        matter_.add_depth(cell, light, middle, part, depth);
        for (std::size_t b = 0; b < bands_ && !added_.empty(); ++b) depth[b] += added(cell, b) * part;
      }
      reached += part;
    };
    return rays_.walk_while(from.cell, from.position, direction, length, add, enter);
  }
  if (bands_ > 1) {
    const auto add = [&](CellIndex cell, double part) {
      const double* extinction = &extinction_[cell.at() * bands_];
      for (std::size_t b = 0; b < bands_; ++b) depth[b] += extinction[b] * part;
    };
    return rays_.walk_while(from.cell, from.position, direction, length, add, enter);
  }
  double only = 0;
  const auto add = [&](CellIndex cell, double part) { only += extinction_[cell.at()] * part; };
  const RayMesh::PartOfPath segment =
      rays_.walk_while(from.cell, from.position, direction, length, add, enter);
  depth[0] += only;
  return segment;
}

RayEnd LightPaths::walk(const PointInCell& from, const Vec3& direction, double length,
                        std::span<double> depth) const {
  const RayMatter::View light = view_along(direction);
  return walk_while(from, direction, length, depth, light, [](CellIndex, double) { return true; }).end;
}

// Near an edge some cells are passed, and then the surfaces are asked again, a few times.
std::optional<LightPaths::Segment> LightPaths::cross(const Place& from, const Vec3& direction, double length,
                                                     std::span<double> depth) const {
  constexpr int most_unclear = 4;
  using Kind = MediumSurfaces::Crossing::Kind;
  const TetrahedralMesh& mesh = problem_.mesh();
  Place at = from;
  std::optional<FaceIndex> through;
  std::optional<RayMatter::View> light;
  double left = length;
  for (int unclear = 0; left > 0;) {
    const std::int32_t medium = surfaces_.medium(at.cell);
    if (medium != MediumSurfaces::varying && unclear < most_unclear) {
      const auto crossing = surfaces_.first(at.position, direction, left, medium, through);
      if (crossing.kind != Kind::unclear) {
        const double* extinction = &extinction_[at.cell.at() * bands_];
        for (std::size_t b = 0; b < bands_; ++b) depth[b] += extinction[b] * crossing.distance;
        left -= crossing.distance;
        if (crossing.kind == Kind::none) break;
        at.position += crossing.distance * direction;
        at.exact = crossing.exact;
        through = crossing.face;
        if (crossing.face.value() < mesh.boundary_face_count()) {
          if (at.exact) at.cell = mesh.owner(crossing.face);
          return Segment{length - left, crossing.face, at};
        }
        at.cell = surfaces_.beyond(crossing.face, direction);
        continue;
      }
      ++unclear;
    }
    if (!at.exact) return std::nullopt;
    if (!light) light = view_along(direction);
    const bool to_the_end = unclear == most_unclear;
    const RayMesh::PartOfPath part =
        walk_while(at, direction, left, depth, *light, [&](CellIndex next, double distance) {
          if (medium == MediumSurfaces::varying) return surfaces_.medium(next) == medium;
          return to_the_end || distance < surfaces_.clear_distance();
        });
    left -= part.end.distance;
    at = {{part.end.cell, part.end.point}};
    if (part.end.wall) return Segment{length - left, part.end.wall, at};
    if (part.entered < 0) break;
    through = FaceIndex(mesh.faces(at.cell)[static_cast<std::size_t>(part.entered)]);
  }
  return Segment{length, {}, at};
}

void LightPaths::reflect(FaceIndex face, std::span<double> factor) const {
  const Wall& wall = problem_.wall(problem_.mesh().wall(face));
  for (std::size_t b = 0; b < bands_; ++b) factor[b] -= std::log(wall.specular[b]);
}

bool LightPaths::transmit(const PointInCell& from, const Vec3& direction, double length, MirrorSet mirrors,
                          std::span<double> transmittance) const {
  const auto open = follow(from, direction, length, mirrors, Steps::surfaces, transmittance);
  return open ? *open : *follow(from, direction, length, mirrors, Steps::cells, transmittance);
}

// `transmittance` holds the optical depth of the path; a mirror adds -log of its reflectance.
std::optional<bool> LightPaths::follow(const PointInCell& from, const Vec3& direction, double length,
                                       MirrorSet mirrors, Steps steps,
                                       std::span<double> transmittance) const {
  std::fill(transmittance.begin(), transmittance.end(), 0.0);
  Place at{from};
  Vec3 along = direction;
  double left = length;
  while (true) {
    std::optional<Segment> segment;
    if (steps == Steps::surfaces) {
      segment = cross(at, along, left, transmittance);
      if (!segment) return std::nullopt;
    } else {
      const RayEnd end = walk(at, along, left, transmittance);
      segment = Segment{end.distance, end.wall, {{end.cell, end.point}}};
    }
    left -= segment->distance;
    const bool at_end = left <= end_of_path * length;
    // What touches a mirror is seen behind it at once, but still via it.
    if (!segment->wall) {
      if (!mirrors_.touches(mirrors, at.position + segment->distance * along, end_of_path * length))
        return false;
      break;
    }
    const int plane = mirrors_.of(*segment->wall);
    if (plane >= 0 && (mirrors >> plane & 1) != 0) {
      mirrors &= ~(MirrorSet{1} << plane);
      reflect(*segment->wall, transmittance);
      at = segment->end;
      along = mirrors_.reflected(plane, along);
    } else if (!at_end) {
      return false;
    }
    if (at_end && mirrors_.touches(mirrors, segment->end.position, end_of_path * length)) break;
    if (at_end) return false;
  }
  for (std::size_t b = 0; b < bands_; ++b)
    transmittance[b] = mirrors_.reflectance(mirrors, b) * std::exp(-transmittance[b]);
  return true;
}

std::optional<WayOut> LightPaths::leave(const PointInCell& from, const Vec3& direction,
                                        std::span<double> transmittance) const {
  std::fill(transmittance.begin(), transmittance.end(), 0.0);
  PointInCell at = from;
  Vec3 along = direction;
  for (int i = 0; i < most_reflections; ++i) {
    const RayEnd end = walk(at, along, std::numeric_limits<double>::infinity(), transmittance);
    const int plane = mirrors_.of(*end.wall);
    if (plane < 0) {
      for (double& value : transmittance) value = std::exp(-value);
      return WayOut{*end.wall, along, end.point};
    }
    reflect(*end.wall, transmittance);
    at = {end.cell, end.point};
    along = mirrors_.reflected(plane, along);
  }
  return std::nullopt;
}

}  // namespace etendue
