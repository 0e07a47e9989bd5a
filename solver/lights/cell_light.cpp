// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/lights/cell_light.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "solver/lights/beam_columns.h"
#include "solver/lights/cell_way.h"
#include "solver/lights/solid_angle.h"
#include "solver/problem/cell_rule.h"

namespace etendue {
namespace {

/// Chords of the unit sphere up to which a rule of degree 5 sees a wedge of a thin cell to about 1e-6; in a
/// thick one transmittance changes faster.
double largest_side(const LitCell& cell) { return 0.35 / std::max(1.0, cell.thickness); }

/// A cell is integrated by fourteen points where it is thicker than this, or nearer than this many sizes.
constexpr double thin = 0.3;
constexpr double far_in_sizes = 8;
/// How often a cell with a shadow's edge is divided in eight.
constexpr int most_divisions = 2;

class PointsOfCell {
 public:
  PointsOfCell(const LightPaths& paths, const LightSource& source, const LitCell& cell, LightBeams& beams,
               NodalMoments& moments)
      : matter_(paths.matter()), source_(source), cell_(cell), beams_(beams), moments_(moments) {}

  void add(const SubTetrahedron& part, double measure, int divisions) {
    NodalMoments sum(4, moments_.components(), beams_.bands());
    std::size_t fewest = SIZE_MAX, most = 0;
    for (const CellPointWeight& point : four_point_rule()) {
      const std::size_t count = add_point(in_whole(point.barycentric, part), point.weight * measure, sum);
      fewest = std::min(fewest, count);
      most = std::max(most, count);
    }
    if (fewest == most || divisions == 0) return moments_.add(sum);
    for (const SubTetrahedron& child : equal_parts(part)) add(child, measure / 8, divisions - 1);
  }

  void add_fourteen() {
    NodalMoments sum(4, moments_.components(), beams_.bands());
    std::size_t fewest = SIZE_MAX, most = 0;
    for (const CellRulePoint& point : cell_rule()) {
      const std::size_t count = add_point(point.barycentric, point.weight * cell_.volume, sum);
      fewest = std::min(fewest, count);
      most = std::max(most, count);
    }
    if (fewest == most) return moments_.add(sum);
    for (const SubTetrahedron& child : equal_parts(whole_cell()))
      add(child, cell_.volume / 8, most_divisions - 1);
  }

 private:
  /// How many beams reach the point.
  std::size_t add_point(const std::array<double, 4>& barycentric, double measure, NodalMoments& sum) {
    beams_.clear();
    source_.add_beams({cell_.index, cell_.position(barycentric)}, Sight::attenuated, coarse_light, beams_);
    for (std::size_t i = 0; i < beams_.size(); ++i) {
      sum.add(barycentric, measure, beams_.direction(i), beams_.fluence(i));
      if (sum.components() > NodalMoments::collided) add_losses_of(i, barycentric, measure, sum);
    }
    return beams_.size();
  }
  void add_losses_of(std::size_t beam, const std::array<double, 4>& barycentric, double measure,
                     NodalMoments& sum) {
    const RayMatter::View view = matter_.view(beams_.direction(beam));
    for (std::size_t b = 0; b < beams_.bands(); ++b)
      add_losses(barycentric, measure, matter_.at(cell_.index, b, view, cell_.position(barycentric)), b,
                 beams_.fluence(beam)[b], sum);
  }

  const RayMatter& matter_;
  const LightSource& source_;
  const LitCell& cell_;
  LightBeams& beams_;
  NodalMoments& moments_;
};

void add_image(const LightPaths& paths, const PointSource& source, const PointSource::Image& image,
               const LitCell& cell, NodalMoments& moments) {
  const std::array<Vec3, 4> gradients = shape_gradients(cell);
  std::array<Vec3, 4> corners = cell.corners;
  for (Vec3& corner : corners) corner -= image.position;
  std::vector<double> power(paths.bands());
  std::vector<SolidAnglePoint> points;
  for (const Wedge& wedge : wedges_of(corners)) {
    points.clear();
    append_points(wedge.directions, largest_side(cell), TriangleRule::seven_points, points);
    for (const SolidAnglePoint& point : points) {
      const double intensity = source.intensity(image, point.direction) * point.weight;
      const double in = wedge.way_in(point.direction), out = wedge.way_out(point.direction);
      const Vec3 entry = image.position + in * point.direction;
      std::fill(power.begin(), power.end(), 1.0);
      if (intensity == 0 ||
          (in > 0 && !paths.transmit({cell.index, entry}, -point.direction, in, image.mirrors, power)))
        continue;
      for (std::size_t b = 0; b < power.size(); ++b) power[b] *= source.power()[b] * intensity;
      add_way(paths.matter(), cell, way_through(cell, gradients, entry, point.direction, out - in), power,
              moments);
    }
  }
}

/// Optical depth by which a column's corners may differ for a rule of degree 5 to see it to about 1e-6.
constexpr double even_depth = 1;
/// And by which the one in the middle may differ from their mean: light from two sides meets at a bend.
constexpr double largest_bend = 0.01;
/// Light that has come so far through matter, 1e-13 of it, may differ as it likes.
constexpr double deepest = 30;
/// Of the light that is sent; so little has no logarithm.
constexpr double smallest = std::numeric_limits<double>::min();
/// How often a column that is in the shadow in part or as it seems in all is cut in four.
constexpr int most_cuts_in_shadow = 4;
/// Corners are looked at so much nearer to the middle of the entry, so that no wall is in doubt.
constexpr double inset = 1e-6;

double spread(const std::array<double, 3>& values) {
  const auto [least, most] = std::ranges::minmax(values);
  return most - least;
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
        power_(paths.bands()),
        moments_(moments) {}

  void add(const Vec3& direction, const Column& column, int cuts = 0) {
    const bool near = is_near(direction, column);
    const bool alike = extinction_ * spread(column.length) <= even_depth;
    if (near && alike) return add_points(direction, column);
    const Light light = light_at_entry(direction, column);
    if (light == Light::none && !near && cuts >= most_cuts_in_shadow) return;
    if (light != Light::faint && (!alike || (!near && is_too_wide(light, cuts))))
      for (const Column& part : column.quarters()) add(direction, part, cuts + 1);
    else
      add_points(direction, column);
  }

 private:
  enum class Light { none, faint, even, uneven, at_edge };

  /// For what is seen of the light at a few points.
  static bool is_too_wide(Light light, int cuts) {
    return light == Light::uneven || (light != Light::even && cuts < most_cuts_in_shadow);
  }

  /// Whether the corners of the entry are so near to each other along the light that what has come to them
  /// through matter like the cell's hardly differs, wherever it came in.
  bool is_near(const Vec3& direction, const Column& column) const {
    std::array<double, 3> begin{};
    for (std::size_t i = 0; i < 3; ++i) begin[i] = direction.dot(column.entry[i]);
    return extinction_ * spread(begin) <= even_depth;
  }

  /// To a flat cell that is wide slanting light comes from far away, but all of it through the same matter.
  Light light_at_entry(const Vec3& direction, const Column& column) {
    const Vec3 middle = (column.entry[0] + column.entry[1] + column.entry[2]) / 3;
    std::vector<std::vector<double>> depths(paths_.bands());  // [band][lit point]
    std::size_t lit = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3 place = i == 3 ? middle : column.entry[i] + inset * (middle - column.entry[i]);
      if (!source_.arrives({cell_.index, place}, direction, power_)) continue;
      ++lit;
      for (std::size_t b = 0; b < power_.size(); ++b)
        if (const double sent = source_.light().irradiance[b]; sent > 0)
          depths[b].push_back(-std::log(std::max(power_[b] / sent, smallest)));
    }
    if (lit == 0) return Light::none;
    if (std::ranges::all_of(depths, is_faint)) return Light::faint;
    if (!std::ranges::all_of(depths, is_even)) return Light::uneven;
    return lit < 4 ? Light::at_edge : Light::even;
  }

  static bool is_faint(const std::vector<double>& depths) {
    return std::ranges::all_of(depths, [](double depth) { return depth > deepest; });
  }

  /// Of three corners and the middle, in this order, where all are lit.
  static bool is_even(const std::vector<double>& depths) {
    if (is_faint(depths)) return true;
    const auto [least, most] = std::ranges::minmax(depths);
    if (most - least > even_depth) return false;
    return depths.size() < 4 || std::abs(depths[3] - (depths[0] + depths[1] + depths[2]) / 3) <= largest_bend;
  }

  void add_points(const Vec3& direction, const Column& column) {
    const double cross_section = column.cross_section(direction);
    for (const FacePointWeight& point : seven_point_rule()) {
      Vec3 entry = Vec3::Zero();
      double length = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        entry += point.barycentric[i] * column.entry[i];
        length += point.barycentric[i] * column.length[i];
      }
      if (!source_.arrives({cell_.index, entry}, direction, power_)) continue;
      for (double& value : power_) value *= point.weight * cross_section;
      add_way(paths_.matter(), cell_, way_through(cell_, gradients_, entry, direction, length), power_,
              moments_);
    }
  }

  const LightPaths& paths_;
  const BeamSource& source_;
  const LitCell& cell_;
  double extinction_;
  std::array<Vec3, 4> gradients_;
  std::vector<double> power_;
  NodalMoments& moments_;
};

}  // namespace

LitCell::LitCell(const LightPaths& paths, CellIndex cell)
    : index(cell),
      volume(paths.problem().mesh().volume(cell)),
      centroid(paths.problem().mesh().centroid(cell)) {
  const TetrahedralMesh& mesh = paths.problem().mesh();
  for (std::size_t i = 0; i < 4; ++i) corners[i] = mesh.point(VertexIndex(mesh.vertices(cell)[i]));
  size = std::cbrt(6 * std::sqrt(2.0) * volume);
  thickness = paths.largest_extinction(cell) * size;
}

void add_in_polar_frame(const LightPaths& paths, const PointSource& source, const LitCell& cell,
                        NodalMoments& moments) {
  for (const PointSource::Image& image : source.images()) add_image(paths, source, image, cell, moments);
}

void add_in_columns(const LightPaths& paths, const BeamSource& source, const LitCell& cell,
                    NodalMoments& moments) {
  BeamInColumns light(paths, source, cell, moments);
  for (const Vec3& direction : source.directions())
    for (const Column& column : columns_of(cell.corners, direction)) light.add(direction, column);
}

void add_by_points(const LightPaths& paths, const LightSource& source, const LitCell& cell, LightBeams& beams,
                   NodalMoments& moments) {
  PointsOfCell points(paths, source, cell, beams, moments);
  if (cell.thickness > thin || source.is_near(cell.centroid, far_in_sizes / 3 * cell.size))
    points.add_fourteen();
  else
    points.add(whole_cell(), cell.volume, most_divisions);
}

}  // namespace etendue
