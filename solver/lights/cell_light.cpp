// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/lights/cell_light.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

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

void add_column(const LightPaths& paths, const BeamSource& source, const Vec3& direction, const LitCell& cell,
                const std::array<Vec3, 4>& gradients, const Column& column, NodalMoments& moments) {
  std::array<double, 3> begin{};
  for (std::size_t i = 0; i < 3; ++i) begin[i] = direction.dot(column.entry[i]);
  const auto spread = [](const std::array<double, 3>& values) {
    const auto [least, most] = std::ranges::minmax(values);
    return most - least;
  };
  const double extinction = cell.thickness / cell.size;
  if (extinction * std::max(spread(begin), spread(column.length)) > even_depth) {
    for (const Column& part : column.quarters())
      add_column(paths, source, direction, cell, gradients, part, moments);
    return;
  }
  const double cross_section = column.cross_section(direction);
  std::vector<double> power(paths.bands());
  for (const FacePointWeight& point : seven_point_rule()) {
    Vec3 entry = Vec3::Zero();
    double length = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      entry += point.barycentric[i] * column.entry[i];
      length += point.barycentric[i] * column.length[i];
    }
    if (!source.arrives({cell.index, entry}, direction, power)) continue;
    for (double& value : power) value *= point.weight * cross_section;
    add_way(paths.matter(), cell, way_through(cell, gradients, entry, direction, length), power, moments);
  }
}

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
  const std::array<Vec3, 4> gradients = shape_gradients(cell);
  for (const Vec3& direction : source.directions())
    for (const Column& column : columns_of(cell.corners, direction))
      add_column(paths, source, direction, cell, gradients, column, moments);
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
