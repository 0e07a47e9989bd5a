// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/generation/tetrahedralize.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <string>

#include <Eigen/Geometry>

#include "base/child_process.h"
#include "base/gibibyte.h"
#include "base/position.h"
#include "mesh/tetrahedra/generation/cell_count.h"
#include "mesh/tetrahedra/generation/narrow_gaps.h"
#include "mesh/tetrahedra/generation/tetgen_call.h"
#include "mesh/tetrahedra/mesh_faults.h"

namespace etendue {
namespace {

/// Below this TetGen's refinement need not end (Si 2015: it ends above 2, in practice above about 1.1).
constexpr double kSmallestQuality = 1.1;

Origin with_key(Origin origin, const std::string& key) {
  origin.key = origin.key.empty() ? key : origin.key + "." + key;
  return origin;
}

/// p: a piecewise linear complex; z: from zero; A, a: attributes and bounds of regions; q: quality; S: the
/// largest number of points that TetGen adds. Where
/// all regions are bounded, the largest bound is also given for the whole: TetGen then cuts the edges of
/// the surface first, and its closing optimisation exceeds the bounds by a few percent instead of by half.
std::string switches(const SurfaceComplex& surface, const TetrahedraOptions& options, int most_added) {
  const auto& bounds = options.max_volume;
  const auto is_bound = [](double volume) { return volume > 0; };
  std::string text = "pzA";
  if (std::any_of(bounds.begin(), bounds.end(), is_bound)) text += "a";
  if (!bounds.empty() && bounds.size() == surface.region_names.size() &&
      std::all_of(bounds.begin(), bounds.end(), is_bound))
    text += "a" + to_text(*std::max_element(bounds.begin(), bounds.end()));
  return text + "q" + to_text(options.quality) + "S" + std::to_string(most_added);
}

void check_options(const SurfaceComplex& surface, const TetrahedraOptions& options) {
  if (!(options.quality >= kSmallestQuality))
    throw InputError(
        fault_at(with_key(options.origin, "quality"), to_text(options.quality),
                 "is too small (refinement would not end); use " + to_text(kSmallestQuality) + " or more"));
  if (surface.facets.empty() || surface.points.empty())
    throw InputError(fault_at(options.origin, "", "the geometry has no surface; give a closed surface"));
  Eigen::AlignedBox3d extent;
  for (const Vec3& point : surface.points) extent.extend(point);
  if (!(extent.sizes().minCoeff() > 0))
    throw InputError(fault_at(options.origin, "",
                              "the geometry is flat (from " + to_text(extent.min()) + " to " +
                                  to_text(extent.max()) + "); give a closed surface"));
  if (surface.seeds.empty())
    throw InputError(fault_at(options.origin, "", "the geometry has no region; give a region a volume"));
}

/// Where two facets meet that must not: TetGen's own search (-d) names two triangles.
std::optional<std::string> find_intersection(const SurfaceComplex& surface, const Log& log) {
  std::optional<std::string> found;
  const Log look = [&](std::string_view line) {
    if (log) log(line);
    std::array<int, 6> v{};
    const std::string text(line);
    const auto start = text.find('(');
    if (found || start == std::string::npos ||
        std::sscanf(text.c_str() + start, "(%d,%d,%d) and (%d,%d,%d)", &v[0], &v[1], &v[2], &v[3], &v[4],
                    &v[5]) != 6)
      return;
    if (std::any_of(v.begin(), v.end(), [&](int p) { return p < 0 || position(p) >= surface.points.size(); }))
      return;
    const auto corners = [&](std::size_t first) {
      return to_text(surface.points[position(v[first])]) + " " +
             to_text(surface.points[position(v[first + 1])]) + " " +
             to_text(surface.points[position(v[first + 2])]);
    };
    found = "triangle " + corners(0) + " meets triangle " + corners(3);
  };
  call_tetgen(surface, {}, "pzd", 0, look);
  return found;
}

/// TetGen 1.5.0 stops on a region's point that is not within the convex hull.
std::optional<std::string> find_outside_point(const TetGenOutcome& outcome, const SurfaceComplex& surface) {
  int number = 0;
  if (std::sscanf(outcome.last_warning.c_str(), "Warning: The %d-th region point lies outside", &number) ==
          1 &&
      number >= 1 && position(number) <= surface.seeds.size()) {
    const RegionSeed& seed = surface.seeds[position(number - 1)];
    return "the point " + to_text(seed.point) + " of region \"" +
           surface.region_names[position(seed.region)] + "\" lies outside the surface; give a point inside";
  }
  return std::nullopt;
}

/// Where the finest detail is, on which TetGen fails most often.
std::string finest_detail(const SurfaceComplex& surface) {
  constexpr double kFine = 1e-3;
  const auto gap = narrowest_gap(surface, kFine);
  return gap ? fmt::format("; the narrowest gap is {:.2g}, at {}", gap->width, to_text(gap->point)) : "";
}

std::string problem_of(const TetGenOutcome& outcome, const SurfaceComplex& surface, const Log& log) {
  switch (outcome.end) {
    case TetGenEnd::out_of_memory:
      return "TetGen needs more memory than there is (" +
             to_text(static_cast<double>(physical_memory()) / gibibyte) +
             " GiB); use a larger max_volume or edge_length";
    case TetGenEnd::self_intersection: {
      const auto place = find_intersection(surface, log);
      return "surfaces intersect each other (" + place.value_or("TetGen: " + outcome.last_words) +
             "); parts may touch along whole facets only";
    }
    case TetGenEnd::small_feature:
      return "a detail is too small to be meshed (TetGen: " + outcome.last_words +
             "); remove points, edges or gaps below 1e-8 of the domain's size" + finest_detail(surface);
    case TetGenEnd::close_facets:
      return "two facets almost coincide (TetGen: " + outcome.last_words + "); join them or move them apart";
    case TetGenEnd::input_error:
      return "TetGen cannot use the surface (" + outcome.last_words + "); give a closed surface";
    case TetGenEnd::out_of_time:
      return fmt::format(
          "TetGen does not end within {:.0f} s of computing; change quality or max_volume a little, or widen "
          "gaps{}",
          outcome.most_seconds, finest_detail(surface));
    case TetGenEnd::interrupted:
      return "TetGen was interrupted; run again";
    case TetGenEnd::done:
    case TetGenEnd::point_limit:
    case TetGenEnd::internal_error:
    case TetGenEnd::killed:
      break;
  }
  if (const auto outside = find_outside_point(outcome, surface)) return *outside;
  return "TetGen failed inside (last it said: " + outcome.last_words +
         "); check that the surface is closed and has no needle-like facets, or change max_volume or "
         "quality a little" +
         finest_detail(surface);
}

Vec3 cell_centroid(const RawMesh& mesh, std::size_t cell) {
  Vec3 sum = Vec3::Zero();
  for (const int point : mesh.cells[cell]) sum += mesh.points[position(point)];
  return sum / 4;
}

void check_regions(const RawMesh& mesh, const SurfaceComplex& surface, const Origin& origin) {
  const auto lost = std::find(mesh.cell_regions.begin(), mesh.cell_regions.end(), -1);
  if (lost != mesh.cell_regions.end())
    throw InputError(fault_at(
        origin, "",
        "the part around " +
            to_text(cell_centroid(mesh, static_cast<std::size_t>(lost - mesh.cell_regions.begin()))) +
            " belongs to no region; give a point inside it for each closed part"));
  for (const RegionSeed& seed : surface.seeds)
    if (std::find(mesh.cell_regions.begin(), mesh.cell_regions.end(), seed.region) == mesh.cell_regions.end())
      throw InputError(fault_at(origin, "",
                                "region \"" + surface.region_names[position(seed.region)] +
                                    "\" got no cells (its point " + to_text(seed.point) +
                                    " lies outside, or in the same part as that of another region); give a "
                                    "point inside a part of its own"));
}

/// A triangle for each side of a sheet, seen from there clockwise: out of the cell on that side.
void add_sheet(const std::array<int, 3>& v, const SurfaceSheet& sheet, RawMesh& mesh) {
  const Vec3& p = mesh.points[position(v[0])];
  const Vec3 turn = (mesh.points[position(v[1])] - p).cross(mesh.points[position(v[2])] - p);
  const bool is_front = turn.dot(sheet.normal) > 0;
  mesh.triangles.push_back(v);
  mesh.triangle_walls.push_back(is_front ? sheet.back : sheet.front);
  mesh.triangles.push_back({v[0], v[2], v[1]});
  mesh.triangle_walls.push_back(is_front ? sheet.front : sheet.back);
}

RawMesh raw_mesh_of(const TetGenMesh& from, const SurfaceComplex& surface) {
  RawMesh mesh;
  mesh.region_names = surface.region_names;
  mesh.wall_names = surface.wall_names;
  for (std::size_t i = 0; i + 2 < from.coordinates.size(); i += 3)
    mesh.points.emplace_back(from.coordinates[i], from.coordinates[i + 1], from.coordinates[i + 2]);
  for (std::size_t i = 0; i + 3 < from.cells.size(); i += 4)
    mesh.cells.push_back({from.cells[i], from.cells[i + 1], from.cells[i + 2], from.cells[i + 3]});
  mesh.cell_regions = from.regions;
  for (std::size_t t = 0; t < from.walls.size(); ++t) {
    const std::array<int, 3> v = {from.triangles[3 * t], from.triangles[3 * t + 1],
                                  from.triangles[3 * t + 2]};
    if (from.sheets[t] >= 0) add_sheet(v, surface.sheets[position(from.sheets[t])], mesh);
    if (from.walls[t] < 0) continue;  // an interface, or a sheet
    mesh.triangles.push_back(v);
    mesh.triangle_walls.push_back(from.walls[t]);
  }
  return mesh;
}

/// With the finest detail of a mesh of fewer points that is not optimized, which takes a part of the time.
[[noreturn]] void refuse_too_fine(const SurfaceComplex& surface, const TetrahedraOptions& options,
                                  int most_added, const Log& log) {
  constexpr int kPart = 8;
  const int few = std::max(1, most_added / kPart);
  const TetGenOutcome outcome = call_tetgen(
      surface, options.max_volume, switches(surface, options, few) + "O0", few, log, AtPointLimit::go_on);
  if (outcome.end != TetGenEnd::done)
    throw InputError(fault_at(options.origin, "", problem_of(outcome, surface, log)));
  refuse_details(outcome.mesh, surface, options, most_added);
}

}  // namespace

RawMesh tetrahedralize(const SurfaceComplex& surface, const TetrahedraOptions& options, const Log& log) {
  check_options(surface, options);
  const double asked = asked_cells(surface, options);
  check_cell_count(asked, options);
  const int most_added = most_added_points(surface, options, asked);
  const TetGenOutcome outcome =
      call_tetgen(surface, options.max_volume, switches(surface, options, most_added), most_added, log);
  if (outcome.end == TetGenEnd::point_limit) refuse_too_fine(surface, options, most_added, log);
  if (outcome.end != TetGenEnd::done)
    throw InputError(fault_at(options.origin, "", problem_of(outcome, surface, log)));
  check_details(outcome.mesh, surface, options, most_added);
  RawMesh mesh = raw_mesh_of(outcome.mesh, surface);
  if (mesh.cells.empty())
    throw InputError(fault_at(options.origin, "",
                              "the surface holds no volume (it is not closed, or all of it is a hole); give "
                              "a closed surface"));
  check_regions(mesh, surface, options.origin);
  return mesh;
}

}  // namespace etendue
