// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/files/gmsh_elements.h"

#include <algorithm>
#include <array>

namespace etendue {
namespace {

constexpr std::int64_t kTriangle = 2;
constexpr std::int64_t kTetrahedron = 4;

// Numbers of element types: Gmsh 4.11 reference manual, section 10.1.
constexpr std::array<std::int64_t, 11> kHigherOrder = {9, 11, 20, 21, 22, 23, 24, 25, 29, 30, 31};
// Points, lines and quadrangles bound nothing that is meshed with tetrahedra.
constexpr std::array<std::int64_t, 9> kPassedOver = {1, 3, 8, 10, 15, 16, 26, 27, 28};

template <std::size_t N>
bool is_one_of(const std::array<std::int64_t, N>& types, std::int64_t type) {
  return std::find(types.begin(), types.end(), type) != types.end();
}

}  // namespace

void GmshElements::read_physical_names(TextLines& lines) {
  lines.next("the number of physical names");
  const std::size_t count = lines.count("number of physical names");
  for (std::size_t i = 0; i < count; ++i) {
    lines.next("a physical name");
    const std::int64_t dimension = lines.integer("dimension", 0, 3);
    const std::int64_t tag = lines.integer("physical tag");
    std::string_view name = lines.rest();
    if (name.size() < 3 || name.front() != '"' || name.back() != '"')
      lines.fail("physical name", name, "must be a text in double quotes");
    name = name.substr(1, name.size() - 2);
    names_[{dimension, tag}] = name;
  }
}

void GmshElements::add_point(TextLines& lines, std::int64_t tag, const Vec3& point) {
  if (!points_.emplace(tag, static_cast<int>(mesh_.points.size())).second)
    lines.fail("node = " + std::to_string(tag) + ": is given twice");
  mesh_.points.push_back(point);
  mesh_.point_numbers.push_back(tag);
}

int GmshElements::point_index(TextLines& lines) const {
  const std::int64_t tag = lines.integer("node");
  const auto found = points_.find(tag);
  if (found == points_.end()) lines.fail("node = " + std::to_string(tag) + ": does not exist");
  return found->second;
}

std::string GmshElements::name(int dimension, std::int64_t physical) const {
  const auto found = names_.find({dimension, physical});
  return found == names_.end() ? std::to_string(physical) : found->second;
}

void GmshElements::add_element(TextLines& lines, std::int64_t tag, std::int64_t type, std::int64_t physical) {
  if (type == kTetrahedron) {
    std::array<int, 4> cell{};
    for (int& point : cell) point = point_index(lines);
    mesh_.cells.push_back(cell);
    mesh_.cell_regions.push_back(regions_.index(physical == 0 ? "domain" : name(3, physical)));
    mesh_.cell_lines.push_back(lines.line());
    mesh_.cell_numbers.push_back(tag);
  } else if (type == kTriangle) {
    if (physical == 0) return;
    std::array<int, 3> triangle{};
    for (int& point : triangle) point = point_index(lines);
    mesh_.triangles.push_back(triangle);
    mesh_.triangle_walls.push_back(walls_.index(name(2, physical)));
  } else if (is_one_of(kHigherOrder, type)) {
    lines.fail("element type = " + std::to_string(type) +
               ": elements of higher order are not read; save the mesh with order 1");
  } else if (!is_one_of(kPassedOver, type)) {
    lines.fail("element type = " + std::to_string(type) +
               ": is not a tetrahedron; mesh the volume with tetrahedra only");
  }
}

RawMesh GmshElements::take(const std::string& file) && {
  mesh_.region_names = regions_.names();
  mesh_.wall_names = walls_.names();
  mesh_.file = file;
  return std::move(mesh_);
}

}  // namespace etendue
