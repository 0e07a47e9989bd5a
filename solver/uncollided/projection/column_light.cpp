// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "solver/uncollided/closed_form/beam_columns.h"
#include "solver/uncollided/projection/arriving_light.h"
#include "solver/uncollided/projection/cell_light.h"
#include "solver/uncollided/projection/ray_segment.h"

namespace etendue {
namespace {

/// Optical depth in the cell by which the corners of a column may differ in length, and the factor between
/// the light along its rays, for a rule of degree 5 to see it to about 1e-6.
constexpr double even_column_depth = 1, even_column_factor = 2.7;
/// Of the light that is sent; it may vary as it likes.
constexpr double negligible_beam = 1e-13;
/// Optical depth that lets through no more.
constexpr double opaque = 30;
/// Part of a cell's volume.
constexpr double sliver = 1e-10;
constexpr int most_column_cuts = 8, most_column_cuts_in_shadow = 4;

std::vector<double> trifle_of(const BeamSource& source) {
  std::vector<double> part = source.light().irradiance;
  for (double& value : part) value *= negligible_beam;
  return part;
}

/// The light of a beam in the columns of a cell.
class BeamInColumns {
 public:
  BeamInColumns(const LightPaths& paths, const BeamSource& source, const LitCell& cell, NodalMoments& moments)
      : paths_(paths),
        source_(source),
        cell_(cell),
        extinction_(cell.thickness / cell.size),
        gradients_(shape_gradients(cell)),
        moments_(moments),
        fluence_(paths.bands()),
        trifle_(trifle_of(source)),
        sliver_(sliver * cell.volume * source.part_of_cell(cell.size)) {}

  /// `parted`: along all edges of shadows.
  void add(const Vec3& direction, const Column& column, bool parted, int cuts = 0) {
    // A sliver holds nothing, and in a flat cell rays from its corners may go wrong.
    const double length = (column.length[0] + column.length[1] + column.length[2]) / 3;
    if (column.cross_section(direction) * length < sliver_) return;
    fluence_.clear();
    for (const FacePointWeight& point : seven_point_rule()) {
      const std::span<double> fluence = fluence_.add();
      if (!source_.arrives({cell_.index, entry(column, point)}, direction, fluence))
        std::ranges::fill(fluence, 0.0);
    }
    // Where nothing arrives something may between the points, unless all edges of shadows are known.
    const bool is_trifle = fluence_.is_trifle(trifle_) && (parted || fluence_.lit() > 0);
    if (!is_trifle && cuts < most_column_cuts && !is_alike(column))
      return add_quarters(direction, column, parted, cuts + 1);
    // Else they are looked for in wide columns only: in the others suns from both sides make up for each
    // other.
    const bool looked_at = parted || is_wide(direction, column);
    const bool at_edge = !parted && cuts < most_column_cuts_in_shadow && fluence_.lit() < fluence_.size();
    if (looked_at && (at_edge || (cuts < most_column_cuts && !fluence_.is_even(even_column_factor, trifle_))))
      return add_quarters(direction, column, parted, cuts + 1);
    add_points(direction, column);
  }

 private:
  void add_quarters(const Vec3& direction, const Column& column, bool parted, int cuts) {
    for (const Column& part : column.quarters()) add(direction, part, parted, cuts);
  }

  /// Returns whether its edges are equally long, or let nothing through.
  bool is_alike(const Column& column) const {
    const auto [least, most] = std::ranges::minmax(column.length);
    return extinction_ * (most - least) <= even_column_depth || extinction_ * least >= opaque;
  }

  /// Returns whether its corners are far from each other along the light.
  bool is_wide(const Vec3& direction, const Column& column) const {
    std::array<double, 3> begin{};
    for (std::size_t i = 0; i < 3; ++i) begin[i] = direction.dot(column.entry[i]);
    const auto [least, most] = std::ranges::minmax(begin);
    return extinction_ * (most - least) > even_column_depth;
  }

  static Vec3 entry(const Column& column, const FacePointWeight& point) {
    return point.barycentric[0] * column.entry[0] + point.barycentric[1] * column.entry[1] +
           point.barycentric[2] * column.entry[2];
  }

  void add_points(const Vec3& direction, const Column& column) {
    const double cross_section = column.cross_section(direction);
    for (std::size_t k = 0; k < fluence_.size(); ++k) {
      if (fluence_.is_dark(k)) continue;
      const FacePointWeight& point = seven_point_rule()[k];
      const std::span<double> power = fluence_.at(k);
      for (double& value : power) value *= point.weight * cross_section;
      double length = 0;
      for (std::size_t i = 0; i < 3; ++i) length += point.barycentric[i] * column.length[i];
      add_segment(paths_.matter(), cell_,
                  segment_through(cell_, gradients_, entry(column, point), direction, length), power,
                  moments_);
    }
  }

  const LightPaths& paths_;
  const BeamSource& source_;
  const LitCell& cell_;
  double extinction_;
  std::array<Vec3, 4> gradients_;
  NodalMoments& moments_;
  ArrivingLight fluence_;       ///< at the entries
  std::vector<double> trifle_;  ///< [band]
  double sliver_;               ///< [length^3]
};

}  // namespace

void add_in_columns(const LightPaths& paths, const BeamSource& source, const ShadowPlanes& shadows,
                    const LitCell& cell, NodalMoments& moments) {
  BeamInColumns light(paths, source, cell, moments);
  std::vector<ShadowPlane> planes;
  for (std::size_t i = 0; i < source.directions().size(); ++i) {
    const Vec3& direction = source.directions()[i];
    const bool parted = shadows.find(i, cell.corners, planes);
    for (const Column& column : columns_of(cell.corners, direction))
      for (const std::array<Vec3, 3>& part : cut_by_planes(column.entry, planes))
        for (const std::array<Vec3, 3>& lit : source.lit_parts(i, part))
          light.add(direction, column.over(lit), parted);
  }
}

}  // namespace etendue
