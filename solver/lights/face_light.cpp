// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/lights/face_light.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "solver/lights/point_source.h"
#include "solver/lights/simplex_rules.h"
#include "solver/lights/solid_angle.h"

namespace etendue {
namespace {

constexpr double largest_side = 0.35;
constexpr double far_in_sizes = 8;

struct LitFace {
  LitFace(const TetrahedralMesh& mesh, FaceIndex face)
      : cell(mesh.owner(face)),
        area(mesh.area(face)),
        size(std::sqrt(2 * area)),
        centroid(mesh.centroid(face)),
        normal(mesh.area_normal(face) / area) {
    for (std::size_t i = 0; i < 3; ++i) corners[i] = mesh.point(VertexIndex(mesh.vertices(face)[i]));
  }

  Vec3 position(const std::array<double, 3>& b) const {
    return b[0] * corners[0] + b[1] * corners[1] + b[2] * corners[2];
  }
  std::array<double, 3> barycentric(const Vec3& point) const {
    const Vec3 along = (corners[1] - corners[0]).cross(corners[2] - corners[0]) / 2;
    const double whole = along.squaredNorm();
    const double first = (corners[1] - point).cross(corners[2] - point).dot(along) / 2 / whole;
    const double second = (corners[2] - point).cross(corners[0] - point).dot(along) / 2 / whole;
    return {first, second, 1 - first - second};
  }

  CellIndex cell;
  double area, size;
  Vec3 centroid, normal;  ///< out of the domain
  std::array<Vec3, 3> corners;
};

/// How often a face with a shadow's edge is divided in four.
constexpr int most_divisions = 3;
/// Optical thickness of the matter along a face from which on its parts are this thin at most.
constexpr double thin = 0.3, even_depth = 0.7;

class PointsOfFace {
 public:
  PointsOfFace(const LightSource& source, const LitFace& face, LightBeams& beams, NodalMoments& moments)
      : source_(source), face_(face), beams_(beams), moments_(moments) {}

  /// In parts over which what media leave changes as slowly as a rule of degree 5 can see.
  void add_in_even_parts(const SubTriangle& part, double measure, double thickness, int divisions) {
    if (thickness <= even_depth) return add(seven_point_rule(), part, measure, divisions);
    for (const SubTriangle& child : equal_parts(part))
      add_in_even_parts(child, measure / 4, thickness / 2, divisions);
  }

  template <class Rule>
  void add(const Rule& rule, const SubTriangle& part, double measure, int divisions) {
    NodalMoments sum(3, 1, beams_.bands());
    std::size_t fewest = SIZE_MAX, most = 0;
    for (const FacePointWeight& point : rule) {
      const std::size_t count = add_point(in_whole(point.barycentric, part), point.weight * measure, sum);
      fewest = std::min(fewest, count);
      most = std::max(most, count);
    }
    if (fewest == most || divisions == 0) return moments_.add(sum);
    for (const SubTriangle& child : equal_parts(part))
      add(three_point_rule(), child, measure / 4, divisions - 1);
  }

 private:
  /// How many beams reach the point.
  std::size_t add_point(const std::array<double, 3>& barycentric, double measure, NodalMoments& sum) {
    beams_.clear();
    source_.add_beams({face_.cell, face_.position(barycentric)}, Sight::attenuated, coarse_light, beams_);
    for (std::size_t k = 0; k < beams_.size(); ++k) {
      const double seen = std::max(0.0, beams_.direction(k).dot(face_.normal)) * measure;
      for (std::size_t b = 0; b < beams_.bands(); ++b)
        for (std::size_t i = 0; i < 3; ++i) sum.at(i, 0, b) += barycentric[i] * seen * beams_.fluence(k)[b];
    }
    return beams_.size();
  }

  const LightSource& source_;
  const LitFace& face_;
  LightBeams& beams_;
  NodalMoments& moments_;
};

void add_image(const LightPaths& paths, const PointSource& source, const PointSource::Image& image,
               const LitFace& face, NodalMoments& moments) {
  const double height = face.normal.dot(face.centroid - image.position);
  constexpr double on_plane = 1e-10;
  if (height <= on_plane * face.size) return;
  std::vector<double> transmittance(paths.bands());
  std::vector<SolidAnglePoint> points;
  append_points(
      {face.corners[0] - image.position, face.corners[1] - image.position, face.corners[2] - image.position},
      largest_side, TriangleRule::seven_points, points);
  for (const SolidAnglePoint& point : points) {
    const double distance = height / face.normal.dot(point.direction);
    const Vec3 position = image.position + distance * point.direction;
    const double intensity = source.intensity(image, point.direction) * point.weight;
    if (intensity == 0 ||
        !paths.transmit({face.cell, position}, -point.direction, distance, image.mirrors, transmittance))
      continue;
    const std::array<double, 3> shape = face.barycentric(position);
    for (std::size_t b = 0; b < paths.bands(); ++b)
      for (std::size_t i = 0; i < 3; ++i)
        moments.at(i, 0, b) += source.power()[b] * intensity * transmittance[b] * shape[i];
  }
}

}  // namespace

void add_irradiance(const LightPaths& paths, const LightSource& source, FaceIndex index, LightBeams& beams,
                    NodalMoments& moments) {
  const LitFace face(paths.problem().mesh(), index);
  const PointSource* point = source.as_point();
  if (point != nullptr && source.is_near(face.centroid, face.size)) {
    for (const PointSource::Image& image : point->images()) add_image(paths, *point, image, face, moments);
    return;
  }
  PointsOfFace points(source, face, beams, moments);
  // A wide light is seen in part from everywhere.
  const int divisions = source.as_wide() != nullptr ? 0 : most_divisions;
  const double thickness = paths.largest_extinction(face.cell) * face.size;
  if (thickness > thin)
    points.add_in_even_parts(whole_face, face.area, thickness, divisions);
  else if (source.is_near(face.centroid, far_in_sizes / 3 * face.size))
    points.add(seven_point_rule(), whole_face, face.area, divisions);
  else
    points.add(three_point_rule(), whole_face, face.area, divisions);
}

}  // namespace etendue
