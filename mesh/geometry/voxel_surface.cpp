// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/geometry/voxel_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "mesh/geometry/wall_naming.h"

namespace etendue {
namespace {

using Voxel = std::array<int, 3>;
constexpr int left_out = -1;

/// Regions of voxels; those beyond the image are left out.
class Regions {
 public:
  Regions(const FieldData& image, const std::map<std::string, int>& labels, const Origin& origin)
      : counts_(image.image->points) {
    if (image.on == FieldValues::on_cells)
      for (int& count : counts_) --count;
    std::map<int, int> region_of;
    std::vector<std::string> names;
    for (const auto& [name, label] : labels) {
      if (!region_of.try_emplace(label, static_cast<int>(names.size())).second)
        throw InputError(fault_at(origin, "", fmt::format("the label {} is given to two regions", label)));
      names.push_back(name);
    }
    std::vector<std::size_t> voxels(names.size(), 0);
    for (std::size_t i = 0; i < image.values.size(); ++i) {
      const double value = image.values[i];
      if (value != std::floor(value) || !std::isfinite(value))
        throw InputError(fault_at(
            origin, "", fmt::format("voxel {} has the value {}; labels are whole numbers", i, value)));
      const auto found = region_of.find(static_cast<int>(value));
      regions_.push_back(found == region_of.end() ? left_out : found->second);
      if (regions_.back() != left_out) ++voxels[static_cast<std::size_t>(regions_.back())];
    }
    for (const auto& [label, region] : region_of)
      if (voxels[static_cast<std::size_t>(region)] == 0)
        throw InputError(fault_at(origin, "",
                                  fmt::format("no voxel has the label {} (region {})", label,
                                              names[static_cast<std::size_t>(region)])));
  }

  const Voxel& counts() const { return counts_; }
  std::size_t index(const Voxel& v) const {
    return static_cast<std::size_t>((v[2] * counts_[1] + v[1]) * counts_[0] + v[0]);
  }
  bool is_in_image(const Voxel& v) const {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (v[axis] < 0 || v[axis] >= counts_[axis]) return false;
    return true;
  }
  int at(const Voxel& v) const { return is_in_image(v) ? regions_[index(v)] : left_out; }

 private:
  Voxel counts_;
  std::vector<int> regions_;
};

Voxel moved(Voxel v, std::size_t axis, int by) {
  v[axis] += by;
  return v;
}

/// Builds the complex face by face.
class VoxelSurface {
 public:
  VoxelSurface(const FieldData& image, const Regions& regions) : grid_(*image.image), regions_(regions) {
    if (image.on == FieldValues::on_points) grid_.origin -= 0.5 * grid_.steps * Vec3::Ones();
    const Voxel& n = regions.counts();
    corner_.assign(static_cast<std::size_t>(n[0] + 1) * static_cast<std::size_t>(n[1] + 1) *
                       static_cast<std::size_t>(n[2] + 1),
                   -1);
  }

  SurfaceComplex build(const std::map<std::string, int>& labels) {
    for (const auto& [name, label] : labels) surface_.region_names.push_back(name);
    for_each_voxel([this](const Voxel& v) { add_faces(v); });
    add_parts();
    surface_.wall_names = walls_.all();
    return std::move(surface_);
  }

 private:
  template <class Use>
  void for_each_voxel(const Use& use) const {
    const Voxel& n = regions_.counts();
    for (int k = 0; k < n[2]; ++k)
      for (int j = 0; j < n[1]; ++j)
        for (int i = 0; i < n[0]; ++i) use(Voxel{i, j, k});
  }

  /// The faces towards rising indices, and those on the lower sides of the image.
  void add_faces(const Voxel& v) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (v[axis] == 0) add_face(moved(v, axis, -1), v, axis);
      add_face(v, moved(v, axis, 1), axis);
    }
  }

  /// Between a voxel and the next one along an axis.
  void add_face(const Voxel& before, const Voxel& after, std::size_t axis) {
    const int from = regions_.at(before), into = regions_.at(after);
    if (from == into) return;
    const std::size_t second = (axis + 1) % 3, third = (axis + 2) % 3;
    SurfaceFacet facet;
    facet.polygons = {{corner(after), corner(moved(after, second, 1)),
                       corner(moved(moved(after, second, 1), third, 1)), corner(moved(after, third, 1))}};
    if (from == left_out || into == left_out)
      facet.wall = wall(from == left_out ? before : after, axis, from == left_out ? -1 : 1);
    surface_.facets.push_back(std::move(facet));
  }

  /// Of a voxel that is left out or beyond the image, seen along an axis.
  int wall(const Voxel& beyond, std::size_t axis, int sign) {
    if (regions_.is_in_image(beyond)) return walls_.number("surface");
    const Vec3 outward = sign * grid_.steps.col(static_cast<Eigen::Index>(axis));
    int most = 0;
    outward.cwiseAbs().maxCoeff(&most);
    return walls_.number(side_name(most, outward[most] > 0 ? 1 : -1));
  }

  /// The number of the lowest corner of a voxel.
  int corner(const Voxel& v) {
    const Voxel& n = regions_.counts();
    int& number = corner_[(static_cast<std::size_t>(v[2]) * static_cast<std::size_t>(n[1] + 1) +
                           static_cast<std::size_t>(v[1])) *
                              static_cast<std::size_t>(n[0] + 1) +
                          static_cast<std::size_t>(v[0])];
    if (number < 0) {
      number = static_cast<int>(surface_.points.size());
      surface_.points.push_back(grid_.origin + grid_.steps * Vec3(v[0], v[1], v[2]));
    }
    return number;
  }

  /// A seed in each part of voxels that hang together by faces; a hole in those left out and shut in.
  void add_parts() {
    const Voxel& n = regions_.counts();
    std::vector<char> seen(
        static_cast<std::size_t>(n[0]) * static_cast<std::size_t>(n[1]) * static_cast<std::size_t>(n[2]), 0);
    for_each_voxel([&](const Voxel& start) {
      if (seen[regions_.index(start)] != 0) return;
      const int region = regions_.at(start);
      bool reaches_side = false;
      std::vector<Voxel> front = {start};
      seen[regions_.index(start)] = 1;
      while (!front.empty()) {
        const Voxel v = front.back();
        front.pop_back();
        for (std::size_t axis = 0; axis < 3; ++axis)
          for (const int by : {-1, 1}) {
            const Voxel next = moved(v, axis, by);
            if (!regions_.is_in_image(next)) {
              reaches_side = true;
            } else if (regions_.at(next) == region && seen[regions_.index(next)] == 0) {
              seen[regions_.index(next)] = 1;
              front.push_back(next);
            }
          }
      }
      const Vec3 middle = grid_.origin + grid_.steps * Vec3(start[0] + 0.5, start[1] + 0.5, start[2] + 0.5);
      if (region != left_out)
        surface_.seeds.push_back({middle, region});
      else if (!reaches_side)
        surface_.holes.push_back(middle);
    });
  }

  ImageGrid grid_;
  const Regions& regions_;
  SurfaceComplex surface_;
  WallNames walls_;
  std::vector<int> corner_;  ///< number of each point of the grid; -1: none yet
};

}  // namespace

SurfaceComplex voxel_surface(const FieldData& image, const std::map<std::string, int>& labels,
                             const Origin& origin) {
  const Regions regions(image, labels, origin);
  return VoxelSurface(image, regions).build(labels);
}

}  // namespace etendue
