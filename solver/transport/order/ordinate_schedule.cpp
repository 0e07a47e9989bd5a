// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/order/ordinate_schedule.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "solver/problem/mirror.h"

namespace etendue {
namespace {

/// Normals that are axes but for rounding.
constexpr double on_axis = 1e-10;

/// The axis that a unit vector is, or is opposite to; -1 where it is neither.
int axis_of(const Vec3& normal) {
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(std::abs(normal[axis]) - 1) < on_axis) return axis;
  return -1;
}

/// Batches decide the order of sums, so they must not depend on the number of threads: small enough to share
/// a small set among a few threads, large enough that adding up batches and reading the moments of angular
/// cells, once for each batch, cost little.
std::int32_t ordinates_per_batch(int ordinates) { return ordinates <= 32 ? 8 : ordinates <= 128 ? 16 : 32; }

/// What ordinates become at mirrors across some axes, and their opposites, which share their sweep order.
class Orbits {
 public:
  Orbits(const DirectionSet& directions, const std::array<bool, 3>& axes)
      : directions_(directions), axes_(axes), seen_(static_cast<std::size_t>(directions.count()), 0) {
    for (std::int32_t m = 0; m < directions.count(); ++m)
      if (!seen_[static_cast<std::size_t>(m)]) orbits_.push_back(orbit_of(m));
    // The largest first: their sizes are powers of 2, so that none lies in two batches.
    std::stable_sort(orbits_.begin(), orbits_.end(),
                     [](const auto& a, const auto& b) { return a.size() > b.size(); });
  }
  const std::vector<std::vector<std::int32_t>>& orbits() const { return orbits_; }

 private:
  std::vector<std::int32_t> orbit_of(std::int32_t m) {
    std::vector<std::int32_t> orbit;
    add(m, orbit);
    for (std::size_t i = 0; i < orbit.size(); ++i) {
      const std::int32_t k = orbit[i];
      add(k ^ 1, orbit);
      for (int axis = 0; axis < 3; ++axis)
        if (axes_[static_cast<std::size_t>(axis)])
          add(directions_.mirrored(OrdinateIndex(k), Vec3::Unit(axis)), orbit);
    }
    return orbit;
  }

  void add(std::int32_t m, std::vector<std::int32_t>& orbit) {
    if (m < 0 || seen_[static_cast<std::size_t>(m)]) return;
    seen_[static_cast<std::size_t>(m)] = 1;
    orbit.push_back(m);
  }

  const DirectionSet& directions_;
  const std::array<bool, 3>& axes_;
  std::vector<char> seen_;
  std::vector<std::vector<std::int32_t>> orbits_;
};

bool every_ordinate_has_images(const DirectionSet& directions) {
  for (std::int32_t m = 0; m < directions.count(); ++m)
    for (int axis = 0; axis < 3; ++axis) {
      const int image = directions.mirrored(OrdinateIndex(m), Vec3::Unit(axis));
      if (image < 0 || image == m) return false;
    }
  return true;
}

}  // namespace

OrdinateSchedule::OrdinateSchedule(const Problem& problem, const DirectionSet& directions, Batches batches)
    : batch_(ordinates_per_batch(directions.count())),
      keeps_images_together_(batches == Batches::of_images && every_ordinate_has_images(directions)) {
  find_axes(problem);
  ordinates_.resize(static_cast<std::size_t>(directions.count()));
  std::iota(ordinates_.begin(), ordinates_.end(), 0);
  std::array<bool, 3> axes;
  for (std::size_t a = 0; a < 3; ++a) axes[a] = keeps_images_together_ || later_[a] != 0;
  if (axes != std::array<bool, 3>{}) {
    ordinates_.clear();
    const Orbits orbits(directions, axes);
    for (const auto& orbit : orbits.orbits()) ordinates_.insert(ordinates_.end(), orbit.begin(), orbit.end());
  }
  for (std::int32_t batch = 0; batch < batch_count(); ++batch)
    std::stable_sort(ordinates_.begin() + batch * batch_, ordinates_.begin() + batch_end(batch),
                     [&](std::int32_t a, std::int32_t b) {
                       const Vec3& left = directions.direction(OrdinateIndex(a));
                       const Vec3& right = directions.direction(OrdinateIndex(b));
                       return std::pair(turns(left), octant(left)) < std::pair(turns(right), octant(right));
                     });
  place_of_.resize(ordinates_.size());
  for (std::int32_t place = 0; place < place_count(); ++place) place_of_[ordinate(place).at()] = place;
  find_groups(directions);
}

void OrdinateSchedule::find_groups(const DirectionSet& directions) {
  group_end_.resize(ordinates_.size());
  for (std::int32_t first = 0, end = 0; first < place_count(); first = end) {
    const std::int32_t most = std::min(batch_end(first / batch_), first + largest_group);
    while (end < most &&
           octant(directions.direction(ordinate(end))) == octant(directions.direction(ordinate(first))))
      ++end;
    std::fill(group_end_.begin() + first, group_end_.begin() + end, end);
  }
}

// A mirror at the lower end of an axis reflects light upwards, and is applied where upward ordinates come
// later.
void OrdinateSchedule::find_axes(const Problem& problem) {
  const TetrahedralMesh& mesh = problem.mesh();
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    if (!is_mirror(problem.wall(mesh.wall(FaceIndex(f))))) continue;
    const Vec3 normal = mesh.area_normal(FaceIndex(f)).normalized();
    const int axis = axis_of(normal);
    if (axis < 0) continue;
    int& later = later_[static_cast<std::size_t>(axis)];
    if (later <= 0) later = normal[axis] < 0 ? 1 : -1;
  }
}

bool OrdinateSchedule::knows_reflections(const Vec3& normal) const {
  const int axis = axis_of(normal);
  return axis >= 0 && later_[static_cast<std::size_t>(axis)] * normal[axis] < 0;
}

// Of the axes with mirrors, how many a direction has been turned about.
int OrdinateSchedule::turns(const Vec3& direction) const {
  int count = 0;
  for (int axis = 0; axis < 3; ++axis) count += later_[static_cast<std::size_t>(axis)] * direction[axis] > 0;
  return count;
}

}  // namespace etendue
