// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/lights/cell_light.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "solver/angle/unit_rule.h"
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
      add_losses(barycentric, measure, matter_.at(cell_.index, b, view, cell_.position(barycentric)), b,
                 beams_.fluence(beam)[b], sum);
  }

  const RayMatter& matter_;
  const LightSource& source_;
  const LitCell& cell_;
  LightBeams& beams_;
  NodalMoments& moments_;
};

/// Light of a point on its way through a cell from `in` to `out` along a direction.
struct Way {
  Vec3 entry;
  Vec3 direction;
  double length;
  std::array<double, 4> shape;  ///< at the entry
  std::array<double, 4> rise;   ///< of the shape functions along the way [1/length]
};

/// Adds the integrals of the shape functions over the way of light of a power per solid angle.
void add_values(const Way& way, const std::array<double, 4>& value, std::size_t band, NodalMoments& moments) {
  for (std::size_t i = 0; i < 4; ++i) {
    moments.at(i, 0, band) += value[i];
    for (std::size_t axis = 0; axis < 3; ++axis)
      moments.at(i, 1 + axis, band) += value[i] * way.direction[static_cast<Eigen::Index>(axis)];
  }
}

void add_even_way(const Way& way, const PathCoefficients& coefficients, std::size_t band, double sent,
                  NodalMoments& moments) {
  const AttenuatedWay attenuated = attenuated_way(coefficients.extinction(), way.length);
  std::array<double, 4> value;
  for (std::size_t i = 0; i < 4; ++i)
    value[i] = sent * (way.shape[i] * attenuated.constant + way.rise[i] * attenuated.linear);
  add_values(way, value, band, moments);
  add_losses(value, 1, coefficients, band, 1, moments);
}

/// Optical thickness over which five nodes integrate what falls off exponentially to 1e-9.
constexpr double thickness_of_panel = 1;

/// Where coefficients rise from one end to the other the optical depth is a square in the length, and its
/// integrals are done by Gauss's rule.
void add_uneven_way(const Way& way, const PathCoefficients& from, const PathCoefficients& to,
                    std::size_t band, double sent, NodalMoments& moments) {
  static const GaussRule rule = unit_rule(5);
  const double first = from.extinction(), rise = to.extinction() - first;
  const double thickness = std::max(first, first + rise) * way.length;
  const int panels = std::clamp(static_cast<int>(std::ceil(thickness / thickness_of_panel)), 1, 64);
  for (int panel = 0; panel < panels; ++panel)
    for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
      const double t = (panel + rule.nodes[k]) / panels, s = t * way.length;
      const double arrives =
          sent * rule.weights[k] * way.length / panels * std::exp(-s * (first + t * rise / 2));
      std::array<double, 4> value;
      for (std::size_t i = 0; i < 4; ++i) value[i] = arrives * (way.shape[i] + way.rise[i] * s);
      add_values(way, value, band, moments);
      add_losses(value, 1,
                 {from.absorption + t * (to.absorption - from.absorption),
                  from.scattering + t * (to.scattering - from.scattering)},
                 band, 1, moments);
    }
}

void add_image(const LightPaths& paths, const PointSource& source, const PointSource::Image& image,
               const LitCell& cell, NodalMoments& moments) {
  const std::array<Vec3, 4> gradients = shape_gradients(cell);
  std::array<Vec3, 4> corners = cell.corners;
  for (Vec3& corner : corners) corner -= image.position;
  const RayMatter& matter = paths.matter();
  const bool uneven = matter.varies(cell.index);
  std::vector<double> transmittance(paths.bands());
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
      Way way{entry, point.direction, out - in, shape_at(cell, gradients, entry), {}};
      for (std::size_t i = 0; i < 4; ++i) way.rise[i] = gradients[i].dot(point.direction);
      const RayMatter::View view = matter.empty() ? RayMatter::View{} : matter.view(point.direction);
      for (std::size_t b = 0; b < paths.bands(); ++b) {
        const double sent = source.power()[b] * intensity * transmittance[b];
        if (uneven)
          add_uneven_way(way, matter.at(cell.index, b, view, entry),
                         matter.at(cell.index, b, view, image.position + out * point.direction), b, sent,
                         moments);
        else
          add_even_way(way, matter.at(cell.index, b, view), b, sent, moments);
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
