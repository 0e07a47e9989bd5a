// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/lights/cell_light.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "solver/lights/attenuation.h"
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

/// Adds what is absorbed and scatters of a fluence, where that depends on its direction.
void add_losses(const std::array<double, 4>& shape, double measure, const PathCoefficients& coefficients,
                std::size_t band, double fluence, NodalMoments& moments) {
  if (moments.components() <= NodalMoments::collided) return;
  moments.add(shape, measure, band, coefficients.absorption * fluence, NodalMoments::absorbed);
  moments.add(shape, measure, band, coefficients.scattering * fluence, NodalMoments::collided);
}

/// The four values of the shape functions at a point.
std::array<double, 4> shape_at(const LitCell& cell, const std::array<Vec3, 4>& gradients, const Vec3& point) {
  std::array<double, 4> shape{};
  for (std::size_t i = 0; i < 4; ++i) shape[i] = 0.25 + gradients[i].dot(point - cell.centroid);
  return shape;
}

std::array<Vec3, 4> shape_gradients(const LitCell& cell) {
  std::array<Vec3, 4> gradients;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3& a = cell.corners[(i + 1) % 4];
    const Vec3 normal = (cell.corners[(i + 2) % 4] - a).cross(cell.corners[(i + 3) % 4] - a);
    gradients[i] = normal / normal.dot(cell.corners[i] - a);
  }
  return gradients;
}

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
      add_losses(barycentric, measure, matter_.at(cell_.index, b, view), b, beams_.fluence(beam)[b], sum);
  }

  const RayMatter& matter_;
  const LightSource& source_;
  const LitCell& cell_;
  LightBeams& beams_;
  NodalMoments& moments_;
};

/// What light that travels in a direction meets in a cell, [band].
void coefficients_along(const LightPaths& paths, CellIndex cell, const Vec3& travel,
                        std::vector<PathCoefficients>& coefficients) {
  const RayMatter& matter = paths.matter();
  const RayMatter::View view = matter.empty() ? RayMatter::View{} : matter.view(travel);
  for (std::size_t b = 0; b < coefficients.size(); ++b) coefficients[b] = matter.at(cell, b, view);
}

void add_image(const LightPaths& paths, const PointSource& source, const PointSource::Image& image,
               const LitCell& cell, NodalMoments& moments) {
  const std::array<Vec3, 4> gradients = shape_gradients(cell);
  std::array<Vec3, 4> corners = cell.corners;
  for (Vec3& corner : corners) corner -= image.position;
  const std::size_t bands = paths.bands();
  std::vector<double> transmittance(bands);
  std::vector<PathCoefficients> coefficients(bands);
  std::vector<SolidAnglePoint> points;
  for (const Wedge& wedge : wedges_of(corners)) {
    points.clear();
    append_points(wedge.directions, largest_side(cell), TriangleRule::seven_points, points);
    for (const SolidAnglePoint& point : points) {
      const double intensity = source.intensity(image, point.direction) * point.weight;
      const double in = wedge.way_in(point.direction), out = wedge.way_out(point.direction);
      const Vec3 entry = image.position + in * point.direction;
      std::fill(transmittance.begin(), transmittance.end(), 1.0);
      if (intensity == 0 || (in > 0 && !paths.transmit({cell.index, entry}, -point.direction, in,
                                                       image.mirrors, transmittance)))
        continue;
      const std::array<double, 4> shape = shape_at(cell, gradients, entry);
      coefficients_along(paths, cell.index, point.direction, coefficients);
      for (std::size_t b = 0; b < bands; ++b) {
        const AttenuatedWay way = attenuated_way(coefficients[b].extinction(), out - in);
        const double sent = source.power()[b] * intensity * transmittance[b];
        std::array<double, 4> value;
        for (std::size_t i = 0; i < 4; ++i) {
          value[i] = sent * (shape[i] * way.constant + gradients[i].dot(point.direction) * way.linear);
          moments.at(i, 0, b) += value[i];
          for (std::size_t axis = 0; axis < 3; ++axis)
            moments.at(i, 1 + axis, b) += value[i] * point.direction[static_cast<Eigen::Index>(axis)];
        }
        add_losses(value, 1, coefficients[b], b, 1, moments);
      }
    }
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

void add_by_points(const LightPaths& paths, const LightSource& source, const LitCell& cell, LightBeams& beams,
                   NodalMoments& moments) {
  PointsOfCell points(paths, source, cell, beams, moments);
  if (cell.thickness > thin || source.is_near(cell.centroid, far_in_sizes / 3 * cell.size))
    points.add_fourteen();
  else
    points.add(whole_cell(), cell.volume, most_divisions);
}

}  // namespace etendue
