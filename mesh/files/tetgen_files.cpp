// SPDX-License-Identifier: AGPL-3.0-or-later
// The formats are those of the TetGen 1.5 manual (Si 2013), section 5.2.
#include "mesh/files/tetgen_files.h"

#include <array>
#include <cstdio>

#include "base/errors.h"
#include "base/name_table.h"
#include "base/text/text_lines.h"

namespace etendue {
namespace {

constexpr char kComment = '#';
constexpr const char* kRegionWithoutAttribute = "domain";
constexpr const char* kWallWithoutMarker = "boundary";

std::filesystem::path sibling(std::filesystem::path path, const char* ending) {
  std::filesystem::path found = path.replace_extension(ending);
  return found;
}

/// An optional number of a header line.
std::int64_t optional_integer(TextLines& lines, std::string_view what, std::int64_t otherwise,
                              std::int64_t most) {
  return lines.rest().empty() ? otherwise : lines.integer(what, 0, most);
}

/// Reads the nodes; gives the number of the first, 0 or 1.
std::int64_t read_nodes(const std::filesystem::path& path, RawMesh& mesh) {
  TextLines lines(path, kComment);
  lines.next("the header");
  const std::size_t count = lines.count("number of points");
  const std::int64_t dimension = optional_integer(lines, "dimension", 3, 3);
  if (dimension != 3) lines.fail("dimension = " + std::to_string(dimension) + ": must be 3");
  std::int64_t first = 0;
  for (std::size_t p = 0; p < count; ++p) {
    lines.next("point " + std::to_string(p + 1) + " of " + std::to_string(count));
    const std::int64_t number = lines.integer("point number");
    if (p == 0) {
      first = number;
      if (first != 0 && first != 1)
        lines.fail("point number = " + std::to_string(number) + ": the first must be 0 or 1");
    }
    if (number != first + static_cast<std::int64_t>(p))
      lines.fail("point number = " + std::to_string(number) + ": must be " +
                 std::to_string(first + static_cast<std::int64_t>(p)) + " (points count up)");
    mesh.points.push_back(lines.point());
    mesh.point_numbers.push_back(number);
  }
  return first;
}

int point_index(TextLines& lines, std::int64_t first, const RawMesh& mesh) {
  return static_cast<int>(
      lines.integer("point", first, first + static_cast<std::int64_t>(mesh.points.size()) - 1) - first);
}

/// 1 for 1.0: attributes are real numbers, used as labels.
std::string label(double attribute) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.15g", attribute);
  return text.data();
}

void read_cells(const std::filesystem::path& path, std::int64_t first, RawMesh& mesh) {
  TextLines lines(path, kComment);
  lines.next("the header");
  const std::size_t count = lines.count("number of cells");
  const std::int64_t corners = optional_integer(lines, "corners", 4, 10);
  const std::int64_t attributes = optional_integer(lines, "number of attributes", 0, 1000);
  if (corners != 4)
    lines.fail("corners = " + std::to_string(corners) + ": must be 4 (cells of higher order are not read)");
  NameTable regions;
  for (std::size_t c = 0; c < count; ++c) {
    lines.next("cell " + std::to_string(c + 1) + " of " + std::to_string(count));
    mesh.cell_numbers.push_back(lines.integer("cell number"));
    std::array<int, 4> cell{};
    for (int& point : cell) point = point_index(lines, first, mesh);
    mesh.cells.push_back(cell);
    mesh.cell_regions.push_back(
        regions.index(attributes > 0 ? label(lines.number("attribute")) : kRegionWithoutAttribute));
    mesh.cell_lines.push_back(lines.line());
  }
  mesh.region_names = regions.names();
  mesh.file = lines.file();
}

void read_faces(const std::filesystem::path& path, std::int64_t first, RawMesh& mesh) {
  TextLines lines(path, kComment);
  lines.next("the header");
  const std::size_t count = lines.count("number of faces");
  const bool has_markers = optional_integer(lines, "boundary markers", 0, 1) == 1;
  NameTable walls;
  for (std::size_t f = 0; f < count; ++f) {
    lines.next("face " + std::to_string(f + 1) + " of " + std::to_string(count));
    lines.integer("face number");
    std::array<int, 3> triangle{};
    for (int& point : triangle) point = point_index(lines, first, mesh);
    const std::int64_t marker = has_markers ? lines.integer("boundary marker") : 0;
    mesh.triangles.push_back(triangle);
    mesh.triangle_walls.push_back(
        walls.index(marker == 0 || marker == -1 ? kWallWithoutMarker : std::to_string(marker)));
  }
  mesh.wall_names = walls.names();
}

}  // namespace

RawMesh read_tetgen_files(const std::filesystem::path& path) {
  RawMesh mesh;
  const std::int64_t first = read_nodes(sibling(path, ".node"), mesh);
  read_cells(sibling(path, ".ele"), first, mesh);
  const std::filesystem::path faces = sibling(path, ".face");
  if (std::filesystem::exists(faces)) read_faces(faces, first, mesh);
  return mesh;
}

}  // namespace etendue
