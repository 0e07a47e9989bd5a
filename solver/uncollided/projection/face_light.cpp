// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/projection/face_light.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/clipped_polygon.h"
#include "base/quadrature/simplex_rules.h"
#include "mesh/tetrahedra/corners.h"
#include "solver/uncollided/closed_form/solid_angle.h"
#include "solver/uncollided/projection/arriving_light.h"
#include "solver/uncollided/sources/beam_source.h"
#include "solver/uncollided/sources/point_source.h"

namespace etendue {
namespace {

constexpr double largest_face_side = 0.35;
constexpr double far_in_face_sizes = 8;

struct LitFace {
  LitFace(const TetrahedralMesh& mesh, FaceIndex face)
      : cell(mesh.owner(face)),
        area(mesh.area(face)),
        size(std::sqrt(2 * area)),
        centroid(mesh.centroid(face)),
        normal(mesh.area_normal(face) / area),
        corners(corners_of(mesh, face)) {}

  Vec3 position(const std::array<double, 3>& b) const {
    return b[0] * corners[0] + b[1] * corners[1] + b[2] * corners[2];
  }
  SubTriangle barycentric(const std::array<Vec3, 3>& part) const {
    return {barycentric(part[0]), barycentric(part[1]), barycentric(part[2])};
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
constexpr int most_shadow_divisions = 3;
/// Optical thickness of the medium along a face from which on it is divided until all that a light brings to
/// its points agrees within a factor, as long as that is not a trifle of what the light would bring.
constexpr double thin_along_face = 0.3, even_face_factor = 2;
/// A wide light's face is not divided below this thickness.
constexpr double even_face_depth = 0.7;
constexpr double negligible_on_face = 1e-13;
constexpr int most_even_divisions = 8;

struct Divisions {
  int in_shadow;
  int even;
};

class PointsOfFace {
 public:
  /// With `beam` light along its direction number `image` alone.
  struct Image {
    const BeamSource* beam = nullptr;
    std::size_t image = 0;
  };
  PointsOfFace(const LightSource& source, Image only, const LitFace& face, LightBeams& beams,
               NodalMoments& moments)
      : source_(source),
        only_(only),
        face_(face),
        beams_(beams),
        moments_(moments),
        arriving_(beams.bands()),
        trifle_(beams.bands(), 0) {
    look(face.centroid, Sight::clear);
    for (std::size_t k = 0; k < beams_.size(); ++k)
      for (std::size_t b = 0; b < beams_.bands(); ++b)
        trifle_[b] += negligible_on_face * beams_.fluence(k)[b];
    // The beam may miss the centroid.
    for (std::size_t b = 0; b < beams_.bands() && only.beam != nullptr; ++b)
      trifle_[b] = negligible_on_face * only.beam->light().irradiance[b];
  }

  /// Divided in four as often as it is in part in a shadow, and as what media leave varies over it.
  template <class Rule>
  void add(const Rule& rule, const SubTriangle& part, double measure, Divisions left) {
    NodalMoments sum(3, 1, beams_.bands());
    std::size_t fewest = SIZE_MAX, most = 0;
    arriving_.clear();
    for (const FacePointWeight& point : rule) {
      const std::size_t count = add_point(in_whole(point.barycentric, part), point.weight * measure, sum);
      fewest = std::min(fewest, count);
      most = std::max(most, count);
    }
    if (fewest != most && left.in_shadow > 0) {
      for (const SubTriangle& child : equal_parts(part))
        add(three_point_rule(), child, measure / 4, {left.in_shadow - 1, 0});
    } else if (left.even > 0 && !arriving_.is_even(even_face_factor, trifle_)) {
      for (const SubTriangle& child : equal_parts(part))
        add(rule, child, measure / 4, {left.in_shadow, left.even - 1});
    } else {
      moments_.add(sum);
    }
  }

 private:
  void look(const Vec3& position, Sight sight) {
    beams_.clear();
    if (only_.beam != nullptr)
      only_.beam->add_beam(only_.image, {face_.cell, position}, sight, beams_);
    else
      source_.add_beams({face_.cell, position}, sight, coarse_light, beams_);
  }
  /// How many beams reach the point.
  std::size_t add_point(const std::array<double, 3>& barycentric, double measure, NodalMoments& sum) {
    look(face_.position(barycentric), Sight::attenuated);
    for (std::size_t k = 0; k < beams_.size(); ++k) {
      const double seen = std::max(0.0, beams_.direction(k).dot(face_.normal)) * measure;
      for (std::size_t b = 0; b < beams_.bands(); ++b)
        for (std::size_t i = 0; i < 3; ++i) sum.at(i, 0, b) += barycentric[i] * seen * beams_.fluence(k)[b];
    }
    const std::span<double> sum_of_beams = arriving_.add();
    for (std::size_t k = 0; k < beams_.size(); ++k)
      for (std::size_t b = 0; b < beams_.bands(); ++b) sum_of_beams[b] += beams_.fluence(k)[b];
    return beams_.size();
  }

  const LightSource& source_;
  Image only_;
  const LitFace& face_;
  LightBeams& beams_;
  NodalMoments& moments_;
  ArrivingLight arriving_;      ///< at the points
  std::vector<double> trifle_;  ///< [band]
};

void add_image(const LightPaths& paths, const PointSource& source, const PointSource::Image& image,
               std::span<const ShadowPlane> planes, const LitFace& face, NodalMoments& moments) {
  const double height = face.normal.dot(face.centroid - image.position);
  constexpr double on_plane = 1e-10;
  if (height <= on_plane * face.size) return;
  std::vector<double> transmittance(paths.bands());
  std::vector<SolidAnglePoint> points;
  const SphericalTriangle seen{face.corners[0] - image.position, face.corners[1] - image.position,
                               face.corners[2] - image.position};
  for (const SphericalTriangle& part : cut_by_planes(seen, planes))
    append_points(part, largest_face_side, TriangleRule::seven_points, points);
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

/// A wide light is seen in part from everywhere, so edges of shadows are nowhere.
void add_wide(const LightSource& source, const LitFace& face, double thickness, PointsOfFace& points) {
  if (thickness > thin_along_face)
    points.add(seven_point_rule(), whole_face, face.area,
               {0, static_cast<int>(std::ceil(std::log2(std::max(1.0, thickness / even_face_depth))))});
  else if (source.is_near(face.centroid, far_in_face_sizes / 3 * face.size))
    points.add(seven_point_rule(), whole_face, face.area, {0, 0});
  else
    points.add(three_point_rule(), whole_face, face.area, {0, 0});
}

}  // namespace

void add_irradiance(const LightPaths& paths, const LightSource& source, const ShadowPlanes& shadows,
                    FaceIndex index, LightBeams& beams, NodalMoments& moments) {
  const LitFace face(paths.problem().mesh(), index);
  std::vector<ShadowPlane> planes;
  const PointSource* point = source.as_point();
  const bool parted = shadows.find(face.corners, planes);
  if (parted && point != nullptr && source.is_near(face.centroid, face.size)) {
    for (std::size_t i = 0; i < point->images().size(); ++i) {
      shadows.find(i, face.corners, planes);
      add_image(paths, *point, point->images()[i], planes, face, moments);
    }
    return;
  }
  const double thickness = paths.largest_extinction(face.cell) * face.size;
  if (source.as_wide() != nullptr) {
    PointsOfFace points(source, {}, face, beams, moments);
    return add_wide(source, face, thickness, points);
  }
  const Divisions divisions{most_shadow_divisions, thickness > thin_along_face ? most_even_divisions : 0};
  const std::vector<std::array<Vec3, 3>> parts = cut_by_planes(face.corners, planes);
  const BeamSource* beam = source.as_beam();
  if (beam == nullptr || !beam->has_profile()) {
    PointsOfFace points(source, {}, face, beams, moments);
    for (const std::array<Vec3, 3>& part : parts)
      points.add(seven_point_rule(), face.barycentric(part), triangle_area(part), divisions);
    return;
  }
  for (std::size_t image = 0; image < beam->directions().size(); ++image) {
    PointsOfFace points(source, {beam, image}, face, beams, moments);
    for (const std::array<Vec3, 3>& part : parts)
      for (const std::array<Vec3, 3>& lit : beam->lit_parts(image, part))
        points.add(seven_point_rule(), face.barycentric(lit), triangle_area(lit), divisions);
  }
}

}  // namespace etendue
