// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>

#include "base/name_table.h"
#include "mesh/geometry/surface_files/polygon_soup.h"
#include "mesh/geometry/surface_files/surface_lines.h"

namespace etendue {
namespace {

Vec3 point_of(const SurfaceLines& lines) {
  return {lines.number(1, "x"), lines.number(2, "y"), lines.number(3, "z")};
}

std::string name_of(const SurfaceLines& lines) {
  return lines.rest().empty() ? "boundary" : std::string(lines.rest());
}

/// The corner of an OBJ face, "7", "7/1" or "7/1/2"; negative ones count from the last point.
int obj_corner(const SurfaceLines& lines, std::size_t word, int point_count) {
  const std::string text(lines.words()[word].substr(0, lines.words()[word].find('/')));
  int corner = 0;
  try {
    corner = std::stoi(text);
  } catch (const std::logic_error&) {
    lines.fail(fmt::format("corner = {}: must be the number of a point", lines.words()[word]));
  }
  const int index = corner < 0 ? point_count + corner : corner - 1;
  if (index < 0 || index >= point_count)
    lines.fail(fmt::format("corner = {}: there are only {} points so far", corner, point_count));
  return index;
}

void expect(const SurfaceLines& lines, std::size_t word, std::string_view keyword) {
  if (word >= lines.words().size() || lines.words()[word] != keyword)
    lines.fail(fmt::format("expected \"{}\" (ASCII STL)", keyword));
}

}  // namespace

PolygonSoup read_ascii_stl(const std::filesystem::path& path) {
  SurfaceLines lines(path);
  PolygonSoup soup;
  NameTable walls;
  int wall = 0;
  while (lines.next()) {
    if (lines.words()[0] == "endsolid") continue;
    if (lines.words()[0] == "solid") {
      wall = walls.index(name_of(lines));
      continue;
    }
    expect(lines, 0, "facet");
    lines.require("\"outer loop\"");
    expect(lines, 0, "outer");
    std::vector<int> triangle;
    for (int corner = 0; corner < 3; ++corner) {
      lines.require("\"vertex\"");
      expect(lines, 0, "vertex");
      triangle.push_back(static_cast<int>(soup.points.size()));
      soup.points.push_back(point_of(lines));
    }
    for (const char* end : {"endloop", "endfacet"}) {
      lines.require(end);
      expect(lines, 0, end);
    }
    soup.polygons.push_back(triangle);
    soup.walls.push_back(wall);
  }
  soup.wall_names = walls.names();
  return soup;
}

PolygonSoup read_obj(const std::filesystem::path& path) {
  SurfaceLines lines(path);
  PolygonSoup soup;
  NameTable walls;
  std::string group, material, object;
  while (lines.next()) {
    const std::string_view keyword = lines.words()[0];
    if (keyword == "v") {
      soup.points.push_back(point_of(lines));
    } else if (keyword == "g" || keyword == "usemtl" || keyword == "o") {
      (keyword == "g" ? group : keyword == "usemtl" ? material : object) = name_of(lines);
    } else if (keyword == "f") {
      if (lines.words().size() < 4) lines.fail("a face needs at least 3 corners");
      std::vector<int> polygon;
      for (std::size_t word = 1; word < lines.words().size(); ++word)
        polygon.push_back(obj_corner(lines, word, static_cast<int>(soup.points.size())));
      soup.polygons.push_back(std::move(polygon));
      soup.walls.push_back(walls.index(!group.empty()      ? group
                                       : !material.empty() ? material
                                       : !object.empty()   ? object
                                                           : "boundary"));
    }
  }
  soup.wall_names = walls.names();
  return soup;
}

}  // namespace etendue
