// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/mesh/tetrahedra/sample_meshes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/tetrahedra/generation/tetrahedralize.h"

namespace etendue {
namespace {

constexpr std::array<const char*, 6> kSides = {"xmin", "xmax", "ymin", "ymax", "zmin", "zmax"};

/// Corner i of a box lies at its high end along axis a where bit a of i is set.
Vec3 corner(const Vec3& low, const Vec3& high, int i) {
  return {i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(), i & 4 ? high.z() : low.z()};
}

constexpr std::array<std::array<int, 4>, 6> kSideCorners = {
    {{0, 2, 6, 4}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 5, 7, 6}}};

/// Adds a box; its sides are walls, or interfaces.
void add_box(SurfaceComplex& surface, const Vec3& low, const Vec3& high, bool walls) {
  const int first = static_cast<int>(surface.points.size());
  for (int i = 0; i < 8; ++i) surface.points.push_back(corner(low, high, i));
  for (std::size_t side = 0; side < 6; ++side) {
    std::vector<int> outline;
    for (const int i : kSideCorners[side]) outline.push_back(first + i);
    surface.facets.push_back({{outline}, {}, walls ? static_cast<int>(side) : -1});
  }
}

/// The cells of a block of eight corners: one along each of the six ways from the first to the last.
template <class CornerOf>
void add_kuhn_cells(RawMesh& mesh, const CornerOf& corner_of) {
  std::array<int, 3> axes = {0, 1, 2};
  do {
    std::array<int, 3> step = {0, 0, 0};
    std::array<int, 4> cell{};
    cell[0] = corner_of(step);
    for (std::size_t i = 0; i < 3; ++i) {
      step[static_cast<std::size_t>(axes[i])] = 1;
      cell[i + 1] = corner_of(step);
    }
    // Odd orders of the axes give cells that are inside out.
    const bool even = axes[0] == (axes[2] + 1) % 3;
    if (!even) std::swap(cell[2], cell[3]);
    mesh.cells.push_back(cell);
    mesh.cell_regions.push_back(0);
  } while (std::next_permutation(axes.begin(), axes.end()));
}

TetrahedralMesh filled(const SurfaceComplex& surface, double max_volume) {
  TetrahedraOptions options;
  options.max_volume.assign(surface.region_names.size(), max_volume);
  return TetrahedralMesh(tetrahedralize(surface, options));
}

}  // namespace

SurfaceComplex cube_surface(double side) {
  SurfaceComplex surface;
  surface.region_names = {"domain"};
  surface.wall_names.assign(kSides.begin(), kSides.end());
  add_box(surface, Vec3::Zero(), Vec3::Constant(side), true);
  surface.seeds.push_back({Vec3::Constant(side / 8), 0});
  return surface;
}

SurfaceComplex two_region_surface(double side) {
  SurfaceComplex surface = cube_surface(side);
  surface.region_names.push_back("inner");
  add_box(surface, Vec3::Constant(side / 4), Vec3::Constant(3 * side / 4), false);
  surface.seeds.push_back({Vec3::Constant(side / 2), 1});
  return surface;
}

TetrahedralMesh cube_mesh(double max_volume, double side) { return filled(cube_surface(side), max_volume); }

TetrahedralMesh two_region_mesh(double max_volume, double side) {
  return filled(two_region_surface(side), max_volume);
}

RawMesh single_tetrahedron_raw() {
  RawMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.cells = {{0, 1, 2, 3}};
  mesh.cell_regions = {0};
  mesh.region_names = {"domain"};
  return mesh;
}

TetrahedralMesh single_tetrahedron() { return TetrahedralMesh(single_tetrahedron_raw()); }

RawMesh kuhn_cube_raw() {
  RawMesh mesh;
  for (int i = 0; i < 8; ++i) mesh.points.push_back(corner(Vec3::Zero(), Vec3::Ones(), i));
  mesh.region_names = {"domain"};
  add_kuhn_cells(mesh, [](const std::array<int, 3>& step) { return step[0] + 2 * step[1] + 4 * step[2]; });
  mesh.wall_names.assign(kSides.begin(), kSides.end());
  for (std::size_t side = 0; side < 6; ++side) {
    // The diagonals of the cells' faces leave from the lowest corner of each side and end at the highest.
    const auto& c = kSideCorners[side];
    mesh.triangles.push_back({c[0], c[1], c[2]});
    mesh.triangles.push_back({c[0], c[2], c[3]});
    mesh.triangle_walls.insert(mesh.triangle_walls.end(), 2, static_cast<int>(side));
  }
  return mesh;
}

TetrahedralMesh cyclic_ring() {
  constexpr int kBlocks = 6;
  constexpr double kTwist = 0.5;  // [rad] of the top against the bottom
  constexpr double kHeight = 0.5;
  RawMesh mesh;
  mesh.region_names = {"domain"};
  for (int block = 0; block < kBlocks; ++block)
    for (int outside = 0; outside < 2; ++outside)
      for (int top = 0; top < 2; ++top) {
        const double angle = 2 * std::numbers::pi * block / kBlocks + kTwist * (top - 0.5);
        const double radius = outside ? 1.0 : 0.5;
        mesh.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), kHeight * top);
      }
  for (int block = 0; block < kBlocks; ++block)
    add_kuhn_cells(mesh, [&](const std::array<int, 3>& step) {
      return 4 * ((block + step[0]) % kBlocks) + 2 * step[1] + step[2];
    });
  return TetrahedralMesh(mesh);
}

}  // namespace etendue
