// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/geometry/arrangement/snapping.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string_view>

#include "mesh/geometry/primitives/primitive_checks.h"

namespace etendue {
namespace {

Eigen::AlignedBox3d extent_of(const BoxPrimitive& box) { return {box.min, box.max}; }

Eigen::AlignedBox3d extent_of(const SpherePrimitive& sphere) {
  const Vec3 radius = Vec3::Constant(sphere.radius);
  return {sphere.center - radius, sphere.center + radius};
}

Eigen::AlignedBox3d extent_of(const CylinderPrimitive& cylinder) {
  const Vec3 radius = Vec3::Constant(cylinder.radius);
  return {cylinder.from.cwiseMin(cylinder.to) - radius, cylinder.from.cwiseMax(cylinder.to) + radius};
}

/// A coordinate or a radius, and the body that has it.
struct Value {
  double* value;
  const Origin* origin;
};

void add_values(BoxPrimitive& box, int axis, std::vector<Value>& values) {
  values.push_back({&box.min[axis], &box.origin});
  values.push_back({&box.max[axis], &box.origin});
}

void add_values(SpherePrimitive& sphere, int axis, std::vector<Value>& values) {
  values.push_back({&sphere.center[axis], &sphere.origin});
}

void add_values(CylinderPrimitive& cylinder, int axis, std::vector<Value>& values) {
  values.push_back({&cylinder.from[axis], &cylinder.origin});
  values.push_back({&cylinder.to[axis], &cylinder.origin});
}

/// In the order of the file: bodies, patches, sheets.
std::vector<Value> coordinates(Geometry& geometry, int axis) {
  std::vector<Value> values;
  for (Primitive& primitive : geometry.primitives)
    std::visit([&](auto& shape) { add_values(shape, axis, values); }, primitive);
  for (Patch& patch : geometry.patches) {
    values.push_back({&patch.min[axis], &patch.origin});
    values.push_back({&patch.max[axis], &patch.origin});
  }
  for (Sheet& sheet : geometry.sheets)
    for (Vec3& corner : sheet.corners) values.push_back({&corner[axis], &sheet.origin});
  return values;
}

std::vector<Value> radii(Geometry& geometry) {
  std::vector<Value> values;
  for (Primitive& primitive : geometry.primitives) {
    if (auto* sphere = std::get_if<SpherePrimitive>(&primitive))
      values.push_back({&sphere->radius, &sphere->origin});
    if (auto* cylinder = std::get_if<CylinderPrimitive>(&primitive))
      values.push_back({&cylinder->radius, &cylinder->origin});
  }
  return values;
}

/// Makes values within a distance of each other equal, and keeps account.
class Snapper {
 public:
  explicit Snapper(double distance) : distance_(distance) {}

  void snap(const std::vector<Value>& values, std::string_view name) {
    std::vector<std::size_t> order(values.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return *values[i].value; });
    for (auto first = order.begin(); first != order.end();) {
      const double most = *values[*first].value + distance_;
      const auto last =
          std::find_if(first, order.end(), [&](std::size_t i) { return *values[i].value > most; });
      const Value& kept = values[*std::min_element(first, last)];
      for (; first != last; ++first) move(values[*first], *kept.value, name);
    }
  }

  void tell(const Log& log, double part) const {
    if (count_ > 0 && log)
      log(fmt::format("mesh.snap = {:g}: coordinates moved: {}, by at most {:.2g}; the first: {}", part,
                      count_, farthest_, first_));
  }

 private:
  void move(const Value& from, double to, std::string_view name) {
    if (*from.value == to) return;
    if (count_ == 0)
      first_ = fmt::format("{} = {} becomes {} ({}, line {})", name, *from.value, to, from.origin->key,
                           from.origin->line);
    farthest_ = std::max(farthest_, std::abs(*from.value - to));
    ++count_;
    *from.value = to;
  }

  double distance_;
  int count_ = 0;
  double farthest_ = 0;
  std::string first_;
};

bool has_vanished(const BoxPrimitive& box) { return !(box.min.array() < box.max.array()).all(); }
bool has_vanished(const SpherePrimitive&) { return false; }
bool has_vanished(const CylinderPrimitive& cylinder) { return cylinder.from == cylinder.to; }

void refuse_vanished(const Geometry& geometry, double distance) {
  std::vector<Fault> faults;
  for (const Primitive& primitive : geometry.primitives)
    if (std::visit([](const auto& shape) { return has_vanished(shape); }, primitive))
      faults.push_back(
          fault_at(base_of(primitive).origin, "",
                   fmt::format("is thinner than {:.2g}, within which mesh.snap makes coordinates "
                               "equal; make it thicker, or mesh.snap smaller",
                               distance)));
  if (!faults.empty()) throw InputError(std::move(faults));
}

}  // namespace

double snap_distance(const Geometry& geometry) {
  Eigen::AlignedBox3d extent;
  for (const Primitive& primitive : geometry.primitives)
    extent.extend(std::visit([](const auto& shape) { return extent_of(shape); }, primitive));
  return extent.isEmpty() ? 0 : geometry.snap * extent.sizes().maxCoeff();
}

Geometry snapped(Geometry geometry, const Log& log) {
  const double distance = snap_distance(geometry);
  Snapper snapper(distance);
  for (int axis = 0; axis < 3; ++axis)
    snapper.snap(coordinates(geometry, axis),
                 std::string_view("xyz").substr(static_cast<std::size_t>(axis), 1));
  snapper.snap(radii(geometry), "radius");
  refuse_vanished(geometry, distance);
  snapper.tell(log, geometry.snap);
  return geometry;
}

}  // namespace etendue
