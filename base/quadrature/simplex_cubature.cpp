// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/quadrature/simplex_cubature.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace etendue {
namespace {

using Function = std::function<void(const Vec3&, std::span<double>)>;

/// Barycentric coordinate of the corner that a point of the rule of degree 2 is near to: of three points in a
/// triangle, of four in a tetrahedron.
double near_share(std::size_t corners) { return corners == 3 ? 2. / 3 : 0.585410196624968515; }

double measure_of(std::span<const Vec3> c) {
  const Vec3 across = (c[1] - c[0]).cross(c[2] - c[0]);
  return c.size() == 3 ? across.norm() / 2 : std::abs(across.dot(c[3] - c[0])) / 6;
}

/// Where values differ between the points of a part, both halves may agree with the whole by chance: the
/// error is at least this part of what the difference makes.
constexpr double distrust = 1. / 32;

struct Part {
  std::vector<Vec3> corners;
  std::vector<double> values;
  double spread = 0;  ///< largest difference between points, times the measure
  double error = 0;
  bool operator<(const Part& other) const { return error < other.error; }
};

Part part_of(std::vector<Vec3> corners, std::size_t count, const Function& function) {
  Part part{std::move(corners), std::vector<double>(count, 0)};
  const auto points = static_cast<double>(part.corners.size());
  Vec3 middle = Vec3::Zero();
  for (const Vec3& corner : part.corners) middle += corner / points;
  const double pull = (points * near_share(part.corners.size()) - 1) / (points - 1);
  std::vector<double> here(count), least, most;
  for (const Vec3& corner : part.corners) {
    std::fill(here.begin(), here.end(), 0.0);
    function(middle + pull * (corner - middle), here);
    if (least.empty()) least = most = here;
    for (std::size_t i = 0; i < count; ++i) {
      part.values[i] += here[i];
      least[i] = std::min(least[i], here[i]);
      most[i] = std::max(most[i], here[i]);
    }
  }
  const double measure = measure_of(part.corners);
  for (std::size_t i = 0; i < count; ++i) {
    part.values[i] *= measure / points;
    part.spread = std::max(part.spread, measure * (most[i] - least[i]));
  }
  return part;
}

/// Across the middle of its longest edge; the error of each half is half of what both differ by from the
/// whole.
std::pair<Part, Part> halves_of(const Part& whole, const Function& function) {
  std::size_t from = 0, to = 1;
  for (std::size_t i = 0; i < whole.corners.size(); ++i)
    for (std::size_t j = i + 1; j < whole.corners.size(); ++j)
      if ((whole.corners[i] - whole.corners[j]).squaredNorm() >
          (whole.corners[from] - whole.corners[to]).squaredNorm())
        from = i, to = j;
  const Vec3 middle = (whole.corners[from] + whole.corners[to]) / 2;
  std::pair<std::vector<Vec3>, std::vector<Vec3>> corners{whole.corners, whole.corners};
  corners.first[to] = middle;
  corners.second[from] = middle;
  Part first = part_of(std::move(corners.first), whole.values.size(), function);
  Part second = part_of(std::move(corners.second), whole.values.size(), function);
  for (std::size_t i = 0; i < whole.values.size(); ++i)
    first.error = std::max(first.error, std::abs(first.values[i] + second.values[i] - whole.values[i]) / 2);
  second.error = std::max(first.error, distrust * second.spread);
  first.error = std::max(first.error, distrust * first.spread);
  return {std::move(first), std::move(second)};
}

/// Parts that are halved before any estimate is believed: 2 to this power.
constexpr int first_halvings = 3;

std::vector<Part> first_parts(std::span<const Vec3> corners, std::size_t count, const Function& function) {
  std::vector<Part> parts = {part_of({corners.begin(), corners.end()}, count, function)};
  for (int i = 0; i < first_halvings; ++i) {
    std::vector<Part> halves;
    for (const Part& part : parts) {
      auto [first, second] = halves_of(part, function);
      halves.push_back(std::move(first));
      halves.push_back(std::move(second));
    }
    parts = std::move(halves);
  }
  return parts;
}

}  // namespace

std::vector<double> integrate_over_simplex(std::span<const Vec3> corners, std::size_t count,
                                           const Function& function, const SimplexEffort& effort) {
  std::vector<Part> heap = first_parts(corners, count, function);
  std::make_heap(heap.begin(), heap.end());
  std::vector<double> sum(count, 0);
  double error = 0;
  const auto count_in = [&](const Part& part, double sign) {
    for (std::size_t i = 0; i < count; ++i) sum[i] += sign * part.values[i];
    error += sign * part.error;
  };
  for (const Part& part : heap) count_in(part, 1);
  for (std::size_t points = 2 * heap.size() * corners.size();
       points < effort.most_points && error > effort.tolerance * *std::ranges::max_element(sum);
       points += 2 * corners.size()) {
    std::pop_heap(heap.begin(), heap.end());
    count_in(heap.back(), -1);
    auto [first, second] = halves_of(heap.back(), function);
    heap.pop_back();
    for (Part* part : {&first, &second}) {
      count_in(*part, 1);
      heap.push_back(std::move(*part));
      std::push_heap(heap.begin(), heap.end());
    }
  }
  return sum;
}

}  // namespace etendue
