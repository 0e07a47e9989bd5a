// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "base/parallel/stage_observer.h"
#include "base/quadrature/cone_cubature.h"
#include "solver/observe/radiance/ray_radiance.h"
#include "solver/observe/sensors/measurement.h"
#include "solver/observe/sensors/sensor.h"
#include "solver/uncollided/lights/light_irradiance.h"

namespace etendue {

/// Reads sensors in a saved solution. The other light comes along rays, as a camera sees it (RayRadiance):
/// irradiance and fluence are integrals over the half range and the sphere by adaptive cubature
/// (integrate_over_cone), so a sensor shows rays of the directions to the next order only.
class SensorReader {
 public:
  /// The arguments must outlive it.
  SensorReader(const LightSetup& lights, const RayRadiance& scene)
      : scene_(scene), lights_(lights), direct_(lights), on_wall_(on_wall_within(scene.problem().mesh())) {}

  /// `locate` finds a cell that holds a point; where there is none, a grid has no numbers (NaN) and nothing
  /// flows through a polygon. Other sensors must be in a cell. A polygon is cut into triangles about its
  /// first corner, each of them into count^2 equal ones with three points of degree 2: the sum converges at
  /// least at order 2 in 1/count; so are the faces of a wall. The same bits for any number of threads.
  using Locate = std::function<std::optional<PointInCell>(const Vec3&)>;
  SensorReading read(const Sensor& sensor, const Locate& locate, int threads) const;
  /// The same, with its rays counted; empty where the counter stopped it.
  std::optional<SensorReading> read(const Sensor& sensor, const Locate& locate, int threads,
                                    StageCounter& counter) const;
  /// Rays that the counter counts while a sensor is read.
  std::size_t rays_of(const Sensor& sensor, const Locate& locate) const;

 private:
  static double on_wall_within(const TetrahedralMesh& mesh);
  struct AtPoint {
    std::vector<double> uncollided, collided, error;
  };
  /// What one thread works with.
  struct Worker {
    RayRadiance::Workspace rays;
    StageCounter& counter;
  };
  /// Integrals by so many rays at most, which are counted.
  ConeIntegrals integrate(const Cone& cone, std::size_t count, const ConeFunctions& functions, int rays,
                          Worker& work) const;
  template <class Read>
  void for_all_points(std::size_t count, int threads, StageCounter& counter, const Read& read) const;
  /// Integral over the half range about a normal, times the cosine, or over the sphere.
  AtPoint irradiance(const PointInCell& place, const Vec3& normal, int rays, Worker& work) const;
  /// What a wall sends into the domain at a point of it.
  AtPoint exitance(const PointInCell& place, const Vec3& inwards, int rays, Worker& work) const;
  AtPoint fluence(const PointInCell& place, const Sensor& sensor, Worker& work) const;
  /// How the wall counts that a ray meets first.
  enum class WallSeen { whole, without_diffuse };
  AtPoint radiance(const PointInCell& place, const Vec3& looking, Worker& work,
                   WallSeen wall = WallSeen::whole) const;
  /// Integrals over a cone, times the cosine to each of the normals where it is positive; a normal of zero
  /// stands for the integral itself.
  std::vector<AtPoint> over_cone(const PointInCell& place, const Cone& cone, std::span<const Vec3> normals,
                                 int rays, Worker& work, WallSeen wall = WallSeen::whole) const;
  /// A point of a rule on a polygon or a wall, and the area that it represents.
  struct FluxPoint {
    PointInCell place;
    Vec3 normal;
    double area;
  };
  std::vector<FluxPoint> flux_points(const Sensor& sensor, const Locate& locate) const;
  /// Irradiance of both sides at a point: on that of the normal, and on the other. What falls on the back of
  /// a wall is what the wall sends in.
  std::vector<AtPoint> both_sides(const FluxPoint& point, const Sensor& sensor, Worker& work) const;
  void read_cone(const PointInCell& place, const Sensor& sensor, Worker& work, SensorReading& reading) const;
  void read_grid(const Sensor& sensor, const Locate& locate, int threads, StageCounter& counter,
                 SensorReading& reading) const;
  void read_flux(const Sensor& sensor, const Locate& locate, int threads, StageCounter& counter,
                 SensorReading& reading) const;
  void read_point(const Sensor& sensor, const Locate& locate, StageCounter& counter,
                  SensorReading& reading) const;

  const RayRadiance& scene_;
  const LightSetup& lights_;
  LightIrradiance direct_;
  double on_wall_;  ///< a point that is so near lies on a wall [length]
};

}  // namespace etendue
