// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/bake/wall_atlas.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <string>

#include "mesh/tetrahedra/corners.h"

namespace etendue {
namespace {

/// Texels around each chart that repeat its edge.
constexpr int margin = 2;

/// Texels grow by this until all charts fit.
constexpr double texel_growth = 1.02;

/// Places stand this part of the way to the middle of their face off its edges.
constexpr double off_the_edge = 1e-4;

/// A flat part of the walls in its own plane.
struct Chart {
  std::vector<std::size_t> triangles;
  Vec3 across, down;               ///< unit
  double left, top;                ///< least coordinates [length]
  double width = 0, height = 0;    ///< [length]
  std::array<int, 2> corner = {};  ///< texel, its margin left out

  std::array<int, 2> texels(double size) const {
    const auto count = [&](double length) { return std::max(1, static_cast<int>(std::ceil(length / size))); };
    return {count(width) + 2 * margin, count(height) + 2 * margin};
  }
};

/// [vertex] the number of the part that it hangs together with.
std::vector<std::int32_t> parts_of(const WallSurface& surface) {
  std::vector<std::int32_t> parent(surface.vertices.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](std::int32_t v) {
    while (parent[static_cast<std::size_t>(v)] != v) v = parent[static_cast<std::size_t>(v)];
    return v;
  };
  for (const auto& triangle : surface.triangles)
    for (const std::int32_t v : triangle) parent[static_cast<std::size_t>(root(v))] = root(triangle[0]);
  for (std::size_t v = 0; v < parent.size(); ++v) parent[v] = root(static_cast<std::int32_t>(v));
  return parent;
}

/// As seen from inside: what is up in the scene is up, and of floors y.
void set_frame(const Vec3& normal, Chart& chart) {
  constexpr double level = 0.99;
  const Vec3 up = std::abs(normal.z()) > level ? Vec3::UnitY() : Vec3::UnitZ();
  chart.down = -(up - up.dot(normal) * normal).normalized();
  chart.across = chart.down.cross(-normal);
}

std::vector<Chart> charts_of(const WallSurface& surface) {
  const std::vector<std::int32_t> part = parts_of(surface);
  std::vector<int> number(part.size(), -1);
  std::vector<Chart> charts;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    int& chart = number[static_cast<std::size_t>(part[static_cast<std::size_t>(surface.triangles[t][0])])];
    if (chart < 0) {
      chart = static_cast<int>(charts.size());
      charts.emplace_back();
      set_frame(surface.vertices[static_cast<std::size_t>(surface.triangles[t][0])].normal, charts.back());
    }
    charts[static_cast<std::size_t>(chart)].triangles.push_back(t);
  }
  for (Chart& chart : charts) {
    double right = -std::numeric_limits<double>::infinity(), bottom = right;
    chart.left = chart.top = -right;
    for (const std::size_t t : chart.triangles)
      for (const std::int32_t v : surface.triangles[t]) {
        const Vec3& point = surface.vertices[static_cast<std::size_t>(v)].position;
        chart.left = std::min(chart.left, chart.across.dot(point));
        chart.top = std::min(chart.top, chart.down.dot(point));
        right = std::max(right, chart.across.dot(point));
        bottom = std::max(bottom, chart.down.dot(point));
      }
    chart.width = right - chart.left;
    chart.height = bottom - chart.top;
  }
  std::ranges::stable_sort(charts, std::greater<>{}, &Chart::height);
  return charts;
}

/// Row by row, the highest first. False where they do not fit.
bool pack(std::vector<Chart>& charts, double texel, int side) {
  int column = 0, row = 0, row_height = 0;
  for (Chart& chart : charts) {
    const auto [width, height] = chart.texels(texel);
    if (column + width > side) {
      row += row_height;
      column = row_height = 0;
    }
    row_height = std::max(row_height, height);
    if (width > side || row + height > side) return false;
    chart.corner = {column + margin, row + margin};
    column += width;
  }
  return true;
}

double packed_texel(std::vector<Chart>& charts, int side) {
  double area = 0, largest = 0;
  for (const Chart& chart : charts) {
    area += chart.width * chart.height;
    largest = std::max({largest, chart.width, chart.height});
  }
  for (double texel = std::sqrt(area) / side; texel < largest; texel *= texel_growth)
    if (pack(charts, texel, side)) return texel;
  throw InputError("the walls have " + std::to_string(charts.size()) +
                   " flat parts, too many for a texture of " + std::to_string(side) + " pixels; use more");
}

/// Fills in the texels of one chart.
class Filler {
 public:
  Filler(const TetrahedralMesh& mesh, WallAtlas& atlas)
      : mesh_(mesh),
        atlas_(atlas),
        inside_(static_cast<std::size_t>(atlas.side) * static_cast<std::size_t>(atlas.side)) {}

  void fill(const Chart& chart) {
    for (const std::size_t t : chart.triangles) offer(chart, t);
  }

  /// Texels in order.
  void finish() {
    for (std::size_t at = 0; at < inside_.size(); ++at)
      if (inside_[at]) {
        atlas_.texels.push_back(at);
        atlas_.places.push_back(inside_[at]->place);
      }
  }

 private:
  struct Best {
    double depth;  ///< in the triangle [texel]; negative outside
    BakePlace place;
  };

  Eigen::Vector2d in_texels(const Chart& chart, const Vec3& point) const {
    return {chart.corner[0] + (chart.across.dot(point) - chart.left) / atlas_.texel,
            chart.corner[1] + (chart.down.dot(point) - chart.top) / atlas_.texel};
  }

  void offer(const Chart& chart, std::size_t t) {
    const FaceIndex face(static_cast<std::int32_t>(t));
    std::array<Eigen::Vector2d, 3> p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = in_texels(chart, corner_of(mesh_, face, i));
    const Eigen::Vector2d low = p[0].cwiseMin(p[1]).cwiseMin(p[2]), high = p[0].cwiseMax(p[1]).cwiseMax(p[2]);
    const auto from = [](double x) { return static_cast<int>(std::floor(x)) - margin; };
    const auto to = [&](double x) {
      return std::min(atlas_.side - 1, static_cast<int>(std::ceil(x)) + margin);
    };
    for (int row = std::max(0, from(low.y())); row <= to(high.y()); ++row)
      for (int column = std::max(0, from(low.x())); column <= to(high.x()); ++column)
        consider(face, p, row, column);
  }

  void consider(FaceIndex face, const std::array<Eigen::Vector2d, 3>& p, int row, int column) {
    const Eigen::Vector2d at(column + 0.5, row + 0.5);
    const auto cross = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
      return a.x() * b.y() - a.y() * b.x();
    };
    const double whole = cross(p[1] - p[0], p[2] - p[0]);
    double depth = std::numeric_limits<double>::infinity(), sum = 0;
    std::array<double, 3> weights;
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector2d &a = p[(i + 1) % 3], &b = p[(i + 2) % 3];
      weights[i] = cross(a - at, b - at) / whole;
      depth = std::min(depth, weights[i] * std::abs(whole) / (b - a).norm());
    }
    std::optional<Best>& best =
        inside_[static_cast<std::size_t>(row) * static_cast<std::size_t>(atlas_.side) +
                static_cast<std::size_t>(column)];
    if (depth < -margin || (best && best->depth >= depth)) return;
    for (double& weight : weights) sum += weight = std::max(weight, off_the_edge);
    Vec3 position = Vec3::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
      weights[i] /= sum;
      position += weights[i] * corner_of(mesh_, face, i);
    }
    best = Best{depth, {face, weights, position}};
  }

  const TetrahedralMesh& mesh_;
  WallAtlas& atlas_;
  std::vector<std::optional<Best>> inside_;  ///< [row][column]
};

}  // namespace

WallAtlas wall_atlas(const WallSurface& surface, const TetrahedralMesh& mesh, int side) {
  std::vector<Chart> charts = charts_of(surface);
  WallAtlas atlas;
  atlas.side = side;
  atlas.texel = packed_texel(charts, side);
  atlas.coordinates.resize(surface.vertices.size());
  Filler filler(mesh, atlas);
  for (const Chart& chart : charts) {
    filler.fill(chart);
    for (const std::size_t t : chart.triangles)
      for (const std::int32_t v : surface.triangles[t]) {
        const Vec3& point = surface.vertices[static_cast<std::size_t>(v)].position;
        atlas.coordinates[static_cast<std::size_t>(v)] = {
            (chart.corner[0] + (chart.across.dot(point) - chart.left) / atlas.texel) / side,
            (chart.corner[1] + (chart.down.dot(point) - chart.top) / atlas.texel) / side};
      }
  }
  filler.finish();
  return atlas;
}

}  // namespace etendue
