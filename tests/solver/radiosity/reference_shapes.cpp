// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/solver/radiosity/reference_shapes.h"
#include "tests/support/checkout.h"

#include <cmath>
#include <fstream>
#include <numbers>
#include <regex>
#include <stdexcept>

namespace etendue {
namespace {

constexpr int facets = 80;
constexpr double far = 50;
constexpr double very_far = 500;
constexpr double tiny = 1e-4;

using Triangles = std::vector<TriangleCorners>;

/// Across z = height, seen from above; or with the axes in another order.
Triangles rectangle(const Vec3& corner, const Vec3& u, const Vec3& v) {
  const std::vector<Vec3> corners = {corner, corner + u, corner + u + v, corner + v};
  return polygon_triangles(corners);
}

Triangles disc(double radius, double height) {
  const double turn = 2 * std::numbers::pi / facets;
  const double stretched = radius * std::sqrt(turn / std::sin(turn));
  const auto at = [&](int i) {
    return Vec3(stretched * std::cos(i * turn), stretched * std::sin(i * turn), height);
  };
  Triangles triangles;
  for (int i = 0; i < facets; ++i) triangles.push_back({height * Vec3::UnitZ(), at(i), at(i + 1)});
  return triangles;
}

/// About z from z = bottom to top, seen from outside.
Triangles tube(double radius, double bottom, double top) {
  const double turn = 2 * std::numbers::pi / facets;
  const double stretched = radius * std::sqrt(turn / std::sin(turn));
  Triangles result;
  for (int i = 0; i < facets; ++i) {
    const auto at = [&](int k, double z) {
      return Vec3(stretched * std::cos(k * turn), stretched * std::sin(k * turn), z);
    };
    const std::vector<Vec3> corners = {at(i, bottom), at(i + 1, bottom), at(i + 1, top), at(i, top)};
    for (const TriangleCorners& t : polygon_triangles(corners)) result.push_back(t);
  }
  return result;
}

/// One facet of those that look alike, or one octant: the others have the same factors.
Triangles one_of(const Triangles& triangles, std::size_t number_alike) {
  return {triangles.begin(),
          triangles.begin() + static_cast<std::ptrdiff_t>(triangles.size() / number_alike)};
}

void add(ReferenceShape& shape, const Triangles& triangles, std::size_t group) {
  shape.scene.insert(shape.scene.end(), triangles.begin(), triangles.end());
  shape.group_of.resize(shape.scene.size(), group);
}

std::vector<double> numbers_in(const std::string& text) {
  // Numbers that follow "=", "(" or a comma.
  static const std::regex number(R"([=(,]\s?([0-9.]+))");
  std::vector<double> numbers;
  for (std::sregex_iterator i(text.begin(), text.end(), number), end; i != end; ++i)
    numbers.push_back(std::stod((*i)[1]));
  return numbers;
}

const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();

void add_flat(const std::string& kind, const std::vector<double>& n, ReferenceShape& shape) {
  shape.is_flat = true;
  if (kind == "parallel_rect_aligned") {
    shape.from = rectangle(Vec3::Zero(), n[0] * x, n[1] * y);
    add(shape, rectangle(n[2] * z, n[1] * y, n[0] * x), 0);
  } else if (kind == "parallel_rect_offset") {
    shape.from = rectangle(n[0] * x + n[2] * y, (n[1] - n[0]) * x, (n[3] - n[2]) * y);
    add(shape, rectangle(n[4] * x + n[6] * y + z, (n[7] - n[6]) * y, (n[5] - n[4]) * x), 0);
  } else if (kind == "perp_rect_common_edge") {
    shape.from = rectangle(Vec3::Zero(), n[0] * x, n[2] * y);
    add(shape, rectangle(Vec3::Zero(), n[2] * y, n[1] * z), 0);
  } else if (kind == "infinite_parallel_strips") {
    shape.from = rectangle(-0.5 * y, n[1] * x, y);
    add(shape, rectangle(-very_far * y + n[0] * z, 2 * very_far * y, n[1] * x), 0);
  } else if (kind == "infinite_perp_strips" || kind == "triangle_345_infinite") {
    const double width = kind == "infinite_perp_strips" ? n[0] : 3;
    const double height = kind == "infinite_perp_strips" ? n[1] : 4;
    shape.from = rectangle(-0.5 * y, width * x, y);
    add(shape, rectangle(-very_far * y, 2 * very_far * y, height * z), 0);
  } else if (kind == "element_parallel_rect_corner") {
    add(shape, rectangle(n[2] * z, n[1] * y, n[0] * x), 0);
  } else if (kind == "element_perp_rect_corner") {
    add(shape, rectangle(n[2] * x, n[0] * z, n[1] * y), 0);
  } else {
    shape.is_flat = false;
  }
  shape.is_element = shape.is_flat && shape.from.empty();
  if (shape.is_element) shape.from = rectangle(-tiny / 2 * (x + y), tiny * x, tiny * y);
}

void add_cylinder(const std::string& row, const std::vector<double>& n, ReferenceShape& shape) {
  const Triangles wall = turned(tube(n[0], 0, n[1])), base = disc(n[0], 0);
  shape.from = one_of(row.find("base->wall") != std::string::npos ? base : wall, facets);
  add(shape, wall, 0);
  add(shape, base, 1);
  add(shape, turned(disc(n[0], n[1])), 1);
}

void add_curved(const std::string& kind, const std::string& row, const std::vector<double>& n,
                ReferenceShape& shape) {
  if (kind == "coaxial_discs") {
    shape.from = one_of(disc(n[0], 0), facets);
    add(shape, turned(disc(n[1], n[2])), 0);
  } else if (kind == "sphere_to_coaxial_disc") {
    shape.from = sphere_triangles(n[1] / 2, 8);
    add(shape, turned(disc(n[0], n[1])), 0);
    add(shape, shape.from, 1);
  } else if (kind == "cylinder_inside") {
    add_cylinder(row, n, shape);
  } else if (kind == "cube_face_to_inscribed_sphere") {
    shape.from = rectangle(-0.5 * (x + y + z), x, y);
    add(shape, sphere_triangles(n[0], 16), 0);
  } else if (kind == "concentric_spheres") {
    const Triangles outer = turned(sphere_triangles(n[0], 6));
    shape.from = one_of(outer, 8);
    add(shape, sphere_triangles(n[1], 8), 0);
    add(shape, outer, 1);
  } else if (kind == "coaxial_cylinders_infinite") {
    shape.from = one_of(turned(tube(n[0], -0.5, 0.5)), facets);
    add(shape, turned(tube(n[0], -far, far)), 0);
    add(shape, tube(n[1], -far, far), 1);
  } else {
    throw std::runtime_error("no such configuration: " + kind);
  }
}

}  // namespace

std::vector<TriangleCorners> polygon_triangles(Corners corners) {
  Triangles triangles;
  for (std::size_t i = 2; i < corners.size(); ++i)
    triangles.push_back({corners[0], corners[i - 1], corners[i]});
  return triangles;
}

std::vector<TriangleCorners> turned(std::vector<TriangleCorners> triangles) {
  for (TriangleCorners& t : triangles) std::swap(t[1], t[2]);
  return triangles;
}

std::vector<TriangleCorners> sphere_triangles(double radius, int divisions) {
  Triangles triangles;
  const auto at = [&](double u, double v, double sign_x, double sign_y, double sign_z) {
    return Vec3(sign_x * (divisions - u - v), sign_y * u, sign_z * v).normalized();
  };
  double area = 0;
  for (int octant = 0; octant < 8; ++octant) {
    const double sx = octant & 1 ? -1 : 1, sy = octant & 2 ? -1 : 1, sz = octant & 4 ? -1 : 1;
    for (int i = 0; i < divisions; ++i)
      for (int j = 0; i + j < divisions; ++j)
        for (int half = 0; half < (i + j + 1 < divisions ? 2 : 1); ++half) {
          TriangleCorners t = {at(i + half, j + half, sx, sy, sz), at(i + 1, j, sx, sy, sz),
                               at(i, j + 1, sx, sy, sz)};
          const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
          if (normal.dot(t[0]) < 0) std::swap(t[1], t[2]);
          area += normal.norm() / 2;
          triangles.push_back(t);
        }
  }
  const double stretched = radius * std::sqrt(4 * std::numbers::pi / area);
  for (TriangleCorners& t : triangles)
    for (Vec3& corner : t) corner *= stretched;
  return triangles;
}

std::vector<ReferenceShape> reference_shapes() {
  std::ifstream file(test::checkout("validation/reference/form_factors.csv"));
  const std::regex row(R"re(([a-z_0-9]+),"([^"]*)",([0-9.e-]+),.*)re");
  std::vector<ReferenceShape> shapes;
  for (std::string line; std::getline(file, line);) {
    std::smatch found;
    if (!std::regex_match(line, found, row)) continue;
    ReferenceShape shape;
    shape.name = line;
    shape.factor = std::stod(found[3]);
    const std::vector<double> numbers = numbers_in(found[2]);
    add_flat(found[1], numbers, shape);
    if (!shape.is_flat) add_curved(found[1], found[2], numbers, shape);
    shapes.push_back(std::move(shape));
  }
  return shapes;
}

std::vector<FlatPatch> sphere_patches(int divisions) {
  std::vector<FlatPatch> patches;
  for (const TriangleCorners& t : turned(sphere_triangles(1, divisions)))
    patches.emplace_back(std::vector{t});
  return patches;
}

}  // namespace etendue
