// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "base/vec3.h"
#include "solver/observe/radiance/glossy_rays.h"

namespace etendue {

/// How the angle from the view becomes a distance from the middle of the picture.
enum class Projection {
  perspective,       ///< as its tangent: straight lines stay straight
  fisheye,           ///< as the angle (equidistant)
  fisheye_equisolid  ///< as the sine of its half: equal areas are equal solid angles
};

/// A pinhole camera, a fisheye, or a camera whose rays are parallel.
struct Camera {
  Vec3 position = Vec3::Zero();
  Vec3 look_at = -Vec3::UnitZ();  ///< what is in the middle of the picture
  Vec3 up = Vec3::UnitZ();        ///< of any length; what points up in the picture
  Projection projection = Projection::perspective;
  double field_of_view = 50;  ///< vertical, of a fisheye across its circle [degree]
  /// Height of what the picture shows [length]; then the rays are parallel and start in the plane through the
  /// position.
  std::optional<double> orthographic;
  std::array<int, 2> pixels{800, 600};  ///< across, down
  int samples = 1;                      ///< rays in a pixel, a square number
  /// Points in each cell on a ray to which light comes straight from the lights, for crisp shafts; 0: what is
  /// scattered once is interpolated between the vertices.
  int shafts = 0;
  /// Rays, a square number, that look from each vertex of a wall for the light that directions brought there
  /// (final gathering); 0: it is taken as the solution has it.
  int gather = 0;
  /// Rays from a point of a glossy wall into directions drawn from its reflectance; 0: it is taken for a
  /// diffuse one of the same mean albedo.
  int glossy = default_glossy_rays;
  /// At most, from a point of a wall to a light with an extent (RayView).
  int shadow_rays = 128;
  bool errors = false;  ///< whether the error of each pixel is estimated, at the cost of more pictures
};

struct CameraRay {
  Vec3 origin;
  Vec3 direction;  ///< unit, away from the camera
};

/// The rays of a camera.
class CameraRays {
 public:
  /// The camera must look somewhere, and not along `up`.
  explicit CameraRays(const Camera& camera);

  /// Returns whether a place of the picture shows something: a fisheye is a circle as wide as the shorter
  /// side.
  bool shows(double across, double down) const;
  /// Through a place of the picture that shows something, in pixels from its upper left corner.
  CameraRay through(double across, double down) const;

 private:
  CameraRay fisheye_ray(const Vec3& aside) const;

  bool parallel_;
  Projection projection_;
  double half_angle_;  ///< of a fisheye, at the rim [rad]
  Vec3 position_;
  Vec3 ahead_;
  Vec3 right_;  ///< of one pixel: a length, its ratio to the distance, or, of a fisheye, to the radius of the
                ///< circle
  Vec3 down_;
  std::array<int, 2> pixels_;
};

}  // namespace etendue
