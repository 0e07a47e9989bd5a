// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/geometry/surface_files/tetgen_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "base/name_table.h"
#include "base/position.h"
#include "mesh/geometry/surface_files/coordinate_range.h"
#include "mesh/geometry/surface_files/outline.h"
#include "mesh/geometry/surface_files/surface_lines.h"
#include "mesh/geometry/surface_files/surface_regions.h"

namespace etendue {
namespace {

/// Reads the lists of a .poly or .smesh file one after the other.
class TetgenReader {
 public:
  TetgenReader(const std::filesystem::path& path, const SurfaceFileOptions& options)
      : path_(path), options_(options), lines_(path) {}

  SurfaceComplex read() {
    lines_.require("the number of points");
    if (lines_.integer(0, "number of points") > 0) {
      read_points(lines_);
    } else {
      SurfaceLines nodes(std::filesystem::path(path_).replace_extension(".node"));
      nodes.require("the number of points");
      read_points(nodes);
    }
    read_facets();
    read_holes();
    read_regions();
    surface_.wall_names = walls_.names();
    return std::move(surface_);
  }

 private:
  int count(const SurfaceLines& lines, std::string_view what) const {
    const int value = lines.integer(0, what);
    if (value < 0) lines.fail(fmt::format("{} = {}: must not be negative", what, value));
    return value;
  }

  void read_points(SurfaceLines& lines) {
    const int points = count(lines, "number of points");
    if (lines.words().size() > 1 && lines.integer(1, "dimension") != 3)
      lines.fail(fmt::format("dimension = {}: must be 3", lines.words()[1]));
    for (int i = 0; i < points; ++i) {
      lines.require(fmt::format("point {} of {}", i + 1, points));
      if (i == 0) first_ = lines.integer(0, "number of the first point");
      surface_.points.push_back(point(lines, 1));
    }
    try {
      check_extent(surface_.points);
    } catch (const std::invalid_argument& fault) {
      lines.fail(fault.what());
    }
  }

  Vec3 point(const SurfaceLines& lines, std::size_t word) const {
    const Vec3 read{lines.number(word, "x"), lines.number(word + 1, "y"), lines.number(word + 2, "z")};
    try {
      return with_z_up(checked_range(options_.scale * read), options_.up);
    } catch (const std::invalid_argument& fault) {
      lines.fail(fault.what());
    }
  }

  int corner(std::size_t word) const {
    const std::int64_t number = lines_.integer(word, "corner"), index = number - first_;
    const auto points = static_cast<std::int64_t>(surface_.points.size());
    if (index < 0 || index >= points)
      lines_.fail(
          fmt::format("corner = {}: there is no such point ({} to {})", number, first_, first_ + points - 1));
    return static_cast<int>(index);
  }

  /// A polygon, which may go on over several lines; `word` becomes the first behind it.
  std::vector<int> polygon(std::size_t& word) {
    const int corners = count(lines_, "number of corners");
    if (corners < 1) lines_.fail("a polygon needs corners");
    std::vector<int> result;
    word = 1;
    while (static_cast<int>(result.size()) < corners) {
      if (word >= lines_.words().size()) {
        lines_.require(fmt::format("corner {} of {}", result.size() + 1, corners));
        word = 0;
      }
      result.push_back(corner(word++));
    }
    return result;
  }

  int wall(std::size_t word) {
    const int marker = has_markers_ && word < lines_.words().size() ? lines_.integer(word, "marker") : 0;
    return walls_.index(marker == 0 || marker == -1 ? "boundary" : std::to_string(marker));
  }

  void read_facets() {
    lines_.require("the number of facets");
    const int facets = count(lines_, "number of facets");
    has_markers_ = lines_.words().size() > 1 && lines_.integer(1, "whether facets have markers") != 0;
    for (int i = 0; i < facets; ++i) {
      lines_.require(fmt::format("facet {} of {}", i + 1, facets));
      if (path_.extension() == ".smesh")
        read_simple_facet();
      else
        read_facet();
    }
  }

  void read_simple_facet() {
    SurfaceFacet facet;
    std::size_t word = 0;
    facet.polygons.push_back(polygon(word));
    facet.wall = wall(word);
    surface_.facets.push_back(std::move(facet));
  }

  void read_facet() {
    SurfaceFacet facet;
    const int polygons = count(lines_, "number of polygons");
    if (polygons < 1) lines_.fail("a facet needs polygons");
    const int openings = lines_.words().size() > 1 ? lines_.integer(1, "number of holes") : 0;
    facet.wall = wall(2);
    for (int i = 0; i < polygons; ++i) {
      lines_.require(fmt::format("polygon {} of {}", i + 1, polygons));
      std::size_t word = 0;
      facet.polygons.push_back(polygon(word));
    }
    for (int i = 0; i < openings; ++i) {
      lines_.require(fmt::format("hole {} of {} of the facet", i + 1, openings));
      facet.openings.push_back(point(lines_, 1));
    }
    surface_.facets.push_back(std::move(facet));
  }

  void read_holes() {
    if (!lines_.next()) return;
    const int holes = count(lines_, "number of holes");
    for (int i = 0; i < holes; ++i) {
      lines_.require(fmt::format("hole {} of {}", i + 1, holes));
      surface_.holes.push_back(point(lines_, 1));
    }
  }

  void read_regions() {
    if (!lines_.next()) return;
    const int regions = count(lines_, "number of regions");
    NameTable names;  // numbers attributes in the order of the file
    for (int i = 0; i < regions; ++i) {
      lines_.require(fmt::format("region {} of {}", i + 1, regions));
      const double attribute = lines_.number(4, "attribute");
      surface_.seeds.push_back({point(lines_, 1), names.index(fmt::format("{}", attribute))});
    }
    surface_.region_names = names.names();
  }

  const std::filesystem::path path_;
  const SurfaceFileOptions& options_;
  SurfaceLines lines_;
  SurfaceComplex surface_;
  NameTable walls_;
  std::int64_t first_ = 0;
  bool has_markers_ = false;
};

int domain_number(std::vector<std::string>& names) {
  const auto known = std::find(names.begin(), names.end(), "domain");
  const auto number = known - names.begin();
  if (known == names.end()) names.emplace_back("domain");
  return static_cast<int>(number);
}

/// Parts that the file neither fills nor empties are "domain".
void fill_rest(SurfaceComplex& surface, const SurfaceFileOptions& options) {
  std::vector<SidedFacet> facets;
  for (const SurfaceFacet& facet : surface.facets)
    if (facet.polygons.front().size() > 2)  // a segment or a lone point shuts nothing in
      facets.push_back(sided_facet(surface.points, facet));
  if (!options.regions.empty()) {
    surface.seeds.clear();
    surface.region_names.clear();
  }
  const FilledParts filled = fill_parts(surface.points, facets, options, surface.region_names);
  std::vector<bool> known(filled.parts.size(), false);
  const auto mark = [&](const Vec3& point) {
    const int part = part_at(point, filled.parts, filled.depth, surface.points, facets);
    if (part >= 0) known[position(part)] = true;
  };
  for (const RegionSeed& seed : surface.seeds) mark(seed.point);
  for (const Vec3& hole : surface.holes) mark(hole);
  for (std::size_t i = 0; i < filled.parts.size(); ++i) {
    if (filled.region[i] >= 0)
      surface.seeds.push_back({filled.parts[i].point, filled.region[i]});
    else if (!known[i])
      surface.seeds.push_back({filled.parts[i].point, domain_number(surface.region_names)});
  }
}

}  // namespace

SurfaceComplex read_tetgen_surface(const std::filesystem::path& path, const SurfaceFileOptions& options) {
  SurfaceComplex surface = TetgenReader(path, options).read();
  if (surface.facets.empty()) throw InputError(Fault{path.string(), 0, "has no facets (nothing to fill)"});
  fill_rest(surface, options);
  if (surface.seeds.empty())
    throw InputError(
        Fault{path.string(), 0, "the facets shut nothing in (the surface is not closed); close it"});
  return surface;
}

}  // namespace etendue
