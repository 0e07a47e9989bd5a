// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/geometry/surface_files/surface_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <stdexcept>

#include "base/position.h"
#include "mesh/geometry/surface_files/coordinate_range.h"
#include "mesh/geometry/surface_files/open_surfaces.h"
#include "mesh/geometry/surface_files/outline.h"
#include "mesh/geometry/surface_files/polygon_soup.h"
#include "mesh/geometry/surface_files/surface_lines.h"
#include "mesh/geometry/surface_files/surface_regions.h"
#include "mesh/geometry/surface_files/surface_sheets.h"
#include "mesh/geometry/surface_files/tetgen_surface.h"

namespace etendue {
namespace {

/// Both kinds may begin with "solid": a binary file is exactly as long as its number of triangles says.
bool is_binary_stl(const std::string& content) {
  constexpr std::size_t kHead = 80, kTriangle = 50;
  if (content.size() < kHead + sizeof(std::uint32_t)) return !content.starts_with("solid");
  std::uint32_t triangles = 0;
  std::memcpy(&triangles, content.data() + kHead, sizeof triangles);
  return content.size() == kHead + sizeof triangles + kTriangle * triangles || !content.starts_with("solid");
}

PolygonSoup read_soup(const std::filesystem::path& path, const std::string& ending) {
  const std::string content = file_content(path);  // also a clear error where it cannot be opened
  if (ending == ".obj") return read_obj(path);
  if (ending == ".stl" && !is_binary_stl(content)) return read_ascii_stl(path);
  return read_by_cgal(path);
}

/// Without regions given, shells inside shells are cavities, and shells inside those are filled again.
void fill_by_turns(FilledParts& filled, std::vector<std::string>& region_names) {
  region_names = {"domain"};
  for (std::size_t i = 0; i < filled.parts.size(); ++i) filled.region[i] = filled.depth[i] % 2 == 1 ? 0 : -1;
}

/// The part that a closed shell lies in: the deepest one around its own.
int part_around(std::size_t part, const FilledParts& filled, const std::vector<Vec3>& points,
                const std::vector<SidedFacet>& facets) {
  for (std::size_t i = 0; i < filled.parts.size(); ++i)
    if (filled.depth[i] == filled.depth[part] - 1 &&
        encloses(filled.parts[i], filled.parts[part].point, points, facets))
      return static_cast<int>(i);
  return -1;
}

SurfaceComplex surface_of_shells(const ClosedSurface& closed, const OpenSurface& open,
                                 const std::vector<std::string>& wall_names,
                                 const SurfaceFileOptions& options) {
  SurfaceComplex surface;
  surface.points = closed.points;
  surface.wall_names = wall_names;
  std::vector<SidedFacet> facets;
  for (const std::array<int, 3>& triangle : closed.triangles)
    facets.push_back(sided_facet(closed.points, triangle));
  FilledParts filled = fill_parts(closed.points, facets, options, surface.region_names);
  if (options.regions.empty()) fill_by_turns(filled, surface.region_names);
  for (std::size_t i = 0; i < filled.parts.size(); ++i) {
    const int outer = part_around(i, filled, closed.points, facets);
    const int region = filled.region[i], beyond = outer < 0 ? -1 : filled.region[position(outer)];
    if (region < 0 && beyond < 0) continue;  // void on both sides
    const bool is_wall = region < 0 || beyond < 0;
    for (const FacetSide& side : filled.parts[i].around) {
      const auto& [a, b, c] = closed.triangles[position(side.facet)];
      surface.facets.push_back({{{a, b, c}}, {}, is_wall ? closed.walls[position(side.facet)] : -1});
    }
  }
  add_part_points(filled, surface);
  if (!open.triangles.empty())
    add_sheets(open, surface, [&](const Vec3& point) {
      const int part = part_at(point, filled.parts, filled.depth, closed.points, facets);
      return part >= 0 && filled.region[position(part)] >= 0;
    });
  return surface;
}

}  // namespace

SurfaceComplex read_surface(const std::filesystem::path& path, const SurfaceFileOptions& options,
                            const Log& log) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  if (ending == ".poly" || ending == ".smesh") return read_tetgen_surface(path, options);
  const auto refuse = [&](const std::string& problem) {
    return InputError(fault_at(options.origin, fmt::format("\"{}\"", path.string()), problem));
  };
  if (ending != ".stl" && ending != ".obj" && ending != ".ply" && ending != ".off")
    throw refuse("is not a kind of surface file; use .poly, .smesh, .stl, .obj, .ply or .off");
  PolygonSoup soup = read_soup(path, ending);
  try {
    for (Vec3& point : soup.points) point = with_z_up(checked_range(options.scale * point), options.up);
    check_extent(soup.points);
    const SoupParts parts = parts_of(soup);
    const SurfaceComplex surface = surface_of_shells(
        close_surface(parts.closed), parts.open.polygons.empty() ? OpenSurface{} : open_surface(parts.open),
        soup.wall_names, options);
    if (log)
      log(fmt::format("surface {}: {} triangles, {} of them sheets, {} walls", path.string(),
                      surface.facets.size(), surface.sheets.size(), surface.wall_names.size()));
    return surface;
  } catch (const std::invalid_argument& fault) {
    throw refuse(fault.what());
  }
}

}  // namespace etendue
