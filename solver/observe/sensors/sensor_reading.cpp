// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/sensors/sensor_reading.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>

#include "base/parallel/parallel_for.h"
#include "base/vector_sums.h"
#include "mesh/tetrahedra/bounding_box.h"
#include "mesh/tetrahedra/corners.h"
#include "solver/observe/sensors/observed_view.h"
#include "solver/observe/sensors/polygon_points.h"
#include "solver/observe/sensors/wall_intensity.h"

namespace etendue {
namespace {

using std::numbers::pi;

/// Estimated relative error at which no more rays are sent.
constexpr double ray_tolerance = 1e-6;

/// Rays that an integral takes at least.
constexpr int fewest_rays = 68;

/// Rays that are counted of an integral.
std::size_t counted_rays(int rays) { return static_cast<std::size_t>(std::max(rays, fewest_rays)); }

/// A point lies on a wall that is so near, in units of the size of the mesh.
constexpr double on_wall = 1e-9;

using Quantity = RadiometricQuantity;

std::size_t value_count(const Sensor& sensor) {
  return static_cast<std::size_t>(sensor.count[0]) * static_cast<std::size_t>(sensor.count[1]);
}

/// The point of a grid where a band has most, or least; the parts are those of that point.
template <class Better>
Measurement extreme_of(const GridReading& grid, std::size_t bands, Quantity quantity, const Better& better) {
  Measurement found{quantity, {}, {}, std::vector<double>(bands, 0)};
  const auto value = [&](std::size_t at) { return grid.uncollided[at] + grid.collided[at]; };
  for (std::size_t b = 0; b < bands; ++b) {
    std::size_t best = b;
    for (std::size_t i = b; i < grid.collided.size(); i += bands)
      if (std::isnan(value(best)) || better(value(i), value(best))) best = i;
    found.uncollided.push_back(grid.uncollided[best]);
    found.collided.push_back(grid.collided[best]);
  }
  return found;
}

Measurement most_of(const GridReading& grid, std::size_t bands, Quantity quantity) {
  return extreme_of(grid, bands, quantity, std::greater<>{});
}

Measurement grid_mean(const GridReading& grid, std::size_t bands, const std::vector<double>& errors) {
  Measurement mean{Quantity::irradiance_mean, std::vector<double>(bands, 0), std::vector<double>(bands, 0),
                   std::vector<double>(bands, 0)};
  const auto known = static_cast<double>(
      std::ranges::count_if(grid.collided, [](double value) { return !std::isnan(value); }));
  const double share = static_cast<double>(bands) / known;
  for (std::size_t i = 0; i < grid.collided.size(); ++i) {
    if (std::isnan(grid.collided[i])) continue;
    mean.uncollided[i % bands] += share * grid.uncollided[i];
    mean.collided[i % bands] += share * grid.collided[i];
    mean.error[i % bands] += share * errors[i];
  }
  return mean;
}

}  // namespace

double SensorReader::on_wall_within(const TetrahedralMesh& mesh) {
  return on_wall * bounding_box(mesh.points()).diagonal();
}

ConeIntegrals SensorReader::integrate(const Cone& cone, std::size_t count, const ConeFunctions& functions,
                                      int rays, Worker& work) const {
  ConeIntegrals found = integrate_over_cone(
      cone, count,
      [&](const Vec3& direction, std::span<double> values) {
        // What a stopped sensor would read is thrown away.
        if (work.counter.stopped()) return;
        functions(direction, values);
        work.counter.add();
      },
      ray_tolerance, rays, [&] { return !work.counter.stopped(); });
  const auto taken = static_cast<std::size_t>(found.directions);
  if (taken < counted_rays(rays)) work.counter.add(counted_rays(rays) - taken);
  return found;
}

/// Calls read(i, worker) for the points of a sensor on all threads.
template <class Read>
void SensorReader::for_all_points(std::size_t count, int threads, StageCounter& counter,
                                  const Read& read) const {
  parallel_for(
      count, threads, 1,
      [&] {
        return Worker{RayRadiance::Workspace(scene_), counter};
      },
      [&](std::size_t i, Worker& work) {
        read(i, work);
        return !counter.stopped();
      });
}

Vec3 grid_point(const Sensor& sensor, int i, int j) {
  return sensor.position + (i + 0.5) / sensor.count[0] * sensor.sides[0] +
         (j + 0.5) / sensor.count[1] * sensor.sides[1];
}

SensorReader::AtPoint SensorReader::radiance(const PointInCell& place, const Vec3& looking, Worker& work,
                                             WallSeen wall) const {
  const std::size_t bands = scene_.bands();
  const bool diffuse = wall == WallSeen::whole;
  AtPoint found{std::vector<double>(bands), std::vector<double>(bands), std::vector<double>(bands, 0)};
  scene_.along(place, looking, {.first_wall_diffuse = diffuse, .lights_shown = false}, work.rays,
               found.collided);
  if (lights_.empty()) return found;
  scene_.along(place, looking, {.first_wall_diffuse = diffuse, .lights_shown = true}, work.rays,
               found.uncollided);
  for (std::size_t b = 0; b < bands; ++b) found.uncollided[b] -= found.collided[b];
  return found;
}

SensorReader::AtPoint SensorReader::irradiance(const PointInCell& place, const Vec3& normal, int rays,
                                               Worker& work) const {
  const RayView view{.lights_shown = false, .shadow_rays = quick_shadow_rays};
  const ConeIntegrals rest = integrate(
      {normal, pi / 2}, scene_.bands(),
      [&](const Vec3& direction, std::span<double> values) {
        scene_.along(place, direction, view, work.rays, values);
        for (double& value : values) value *= normal.dot(direction);
      },
      rays, work);
  return {direct_.at(place, normal).irradiance, rest.values, rest.errors};
}

SensorReader::AtPoint SensorReader::fluence(const PointInCell& place, const Sensor& sensor,
                                            Worker& work) const {
  const RayView view{.lights_shown = false, .shadow_rays = quick_shadow_rays};
  const ConeIntegrals rest = integrate(
      {Vec3::UnitZ(), pi}, scene_.bands(),
      [&](const Vec3& direction, std::span<double> values) {
        scene_.along(place, direction, view, work.rays, values);
      },
      sensor.rays, work);
  return {direct_.at(place, Vec3::UnitZ()).fluence, rest.values, rest.errors};
}

// Lights with an extent are seen by the rays; those without are beams, which no ray meets.
std::vector<SensorReader::AtPoint> SensorReader::over_cone(const PointInCell& place, const Cone& cone,
                                                           std::span<const Vec3> normals, int rays,
                                                           Worker& work, WallSeen wall) const {
  const std::size_t bands = scene_.bands();
  const auto weight = [](const Vec3& normal, const Vec3& looking) {
    return normal.isZero() ? 1 : std::max(0.0, normal.dot(looking));
  };
  // [normal][uncollided, collided][band]
  const ConeIntegrals seen = integrate(
      cone, 2 * bands * normals.size(),
      [&](const Vec3& looking, std::span<double> values) {
        const AtPoint here = radiance(place, looking, work, wall);
        for (std::size_t i = 0; i < normals.size(); ++i)
          for (std::size_t b = 0; b < bands; ++b) {
            values[2 * i * bands + b] = weight(normals[i], looking) * here.uncollided[b];
            values[(2 * i + 1) * bands + b] = weight(normals[i], looking) * here.collided[b];
          }
      },
      rays, work);
  LightBeams beams(bands);
  for (const auto& source : lights_.sources())
    if (source->as_wide() == nullptr) source->add_beams(place, Sight::attenuated, fine_light, beams);
  std::vector<AtPoint> found(normals.size());
  for (std::size_t i = 0; i < normals.size(); ++i)
    for (std::size_t b = 0; b < bands; ++b) {
      const std::size_t first = 2 * i * bands + b;
      double thin = 0;
      for (std::size_t k = 0; k < beams.size(); ++k)
        if (cone.holds(-beams.direction(k)))
          thin += beams.fluence(k)[b] * weight(normals[i], -beams.direction(k));
      found[i].uncollided.push_back(seen.values[first] + thin);
      found[i].collided.push_back(seen.values[first + bands]);
      found[i].error.push_back(seen.errors[first] + seen.errors[first + bands]);
    }
  return found;
}

void SensorReader::read_cone(const PointInCell& place, const Sensor& sensor, Worker& work,
                             SensorReading& reading) const {
  const Cone cone{sensor.direction, sensor.half_angle};
  const std::array<Vec3, 2> normals = {Vec3::Zero(), cone.axis};
  std::vector<AtPoint> found = over_cone(place, cone, normals, sensor.rays, work);
  for (std::vector<double>* values : {&found[0].uncollided, &found[0].collided, &found[0].error})
    for (double& value : *values) value /= cone.solid_angle();
  for (std::size_t i = 0; i < 2; ++i)
    reading.measurements.push_back({i == 0 ? Quantity::radiance_mean : Quantity::irradiance,
                                    found[i].uncollided, found[i].collided, found[i].error});
}

void SensorReader::read_grid(const Sensor& sensor, const Locate& locate, int threads, StageCounter& counter,
                             SensorReading& reading) const {
  const std::size_t bands = scene_.bands(), points = value_count(sensor);
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  reading.grid = {std::vector<double>(points * bands, none), std::vector<double>(points * bands, none)};
  std::vector<double> errors(points * bands, 0);
  for_all_points(points, threads, counter, [&](std::size_t p, Worker& work) {
    const auto columns = static_cast<std::size_t>(sensor.count[0]);
    const Vec3 point = grid_point(sensor, static_cast<int>(p % columns), static_cast<int>(p / columns));
    const std::optional<PointInCell> place = locate(point);
    if (!place) {
      counter.add(counted_rays(sensor.rays));
      return;
    }
    const AtPoint here = irradiance(*place, sensor.direction, sensor.rays, work);
    for (std::size_t b = 0; b < bands; ++b) {
      reading.grid.uncollided[p * bands + b] = here.uncollided[b];
      reading.grid.collided[p * bands + b] = here.collided[b];
      errors[p * bands + b] = here.error[b];
    }
  });
  reading.measurements = {grid_mean(reading.grid, bands, errors),
                          extreme_of(reading.grid, bands, Quantity::irradiance_least, std::less<>{}),
                          most_of(reading.grid, bands, Quantity::irradiance_most)};
}

std::vector<SensorReader::FluxPoint> SensorReader::flux_points(const Sensor& sensor,
                                                               const Locate& locate) const {
  std::vector<FluxPoint> points;
  if (sensor.wall < 0) {
    const Vec3 normal = polygon_normal(sensor.polygon);
    for (const PolygonPoint& point : polygon_points(sensor.polygon, sensor.count[0]))
      if (const auto place = locate(point.position)) points.push_back({*place, normal, point.area});
    return points;
  }
  const TetrahedralMesh& mesh = scene_.problem().mesh();
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    if (mesh.wall(face) != sensor.wall) continue;
    const std::array<Vec3, 3> corners = corners_of(mesh, face);
    for (const PolygonPoint& point : polygon_points({corners.begin(), corners.end()}, sensor.count[0]))
      points.push_back({{mesh.owner(face), point.position}, mesh.area_normal(face).normalized(), point.area});
  }
  return points;
}

std::vector<SensorReader::AtPoint> SensorReader::both_sides(const FluxPoint& point, const Sensor& sensor,
                                                            Worker& work) const {
  const std::array<Vec3, 2> normals = {point.normal, -point.normal};
  if (sensor.half_angle > 0)
    return over_cone(point.place, {sensor.direction, sensor.half_angle}, normals, sensor.rays, work);
  const AtPoint before = sensor.wall < 0 ? irradiance(point.place, normals[0], sensor.rays, work)
                                         : exitance(point.place, normals[1], sensor.rays, work);
  return {before, irradiance(point.place, normals[1], sensor.rays, work)};
}

// The wall as it is seen at no distance, mirrors and all; what it reflects diffusely is the same in all
// directions, and of the lights as exact as their irradiance. To be reflected diffusely is to collide.
SensorReader::AtPoint SensorReader::exitance(const PointInCell& place, const Vec3& inwards, int rays,
                                             Worker& work) const {
  const std::array<Vec3, 1> normal = {-inwards};
  const Cone half{-inwards, pi / 2};
  const std::vector<double> lit = direct_.at(place, inwards).irradiance;
  const RayRadiance::DiffuseWall wall = scene_.diffuse_wall(place, -inwards, lit, work.rays);
  if (wall.distance > on_wall_) return over_cone(place, half, normal, rays, work).front();
  AtPoint sent = over_cone(place, half, normal, rays, work, WallSeen::without_diffuse).front();
  add_to(sent.collided, wall.radiance, pi);
  return sent;
}

void SensorReader::read_flux(const Sensor& sensor, const Locate& locate, int threads, StageCounter& counter,
                             SensorReading& reading) const {
  const std::vector<FluxPoint> points = flux_points(sensor, locate);
  std::vector<std::vector<AtPoint>> found(points.size());
  for_all_points(points.size(), threads, counter,
                 [&](std::size_t p, Worker& work) { found[p] = both_sides(points[p], sensor, work); });
  if (counter.stopped()) return;
  const std::vector<double> nothing(scene_.bands(), 0);
  Measurement forward{Quantity::flux_forward, nothing, nothing, nothing};
  Measurement backward{Quantity::flux_backward, nothing, nothing, nothing};
  Measurement net{Quantity::flux_net, nothing, nothing, nothing};
  // Light that goes forward falls on the back.
  const auto add = [](Measurement& sum, const AtPoint& part, double area) {
    add_to(sum.uncollided, part.uncollided, area);
    add_to(sum.collided, part.collided, area);
    add_to(sum.error, part.error, std::abs(area));
  };
  for (std::size_t p = 0; p < points.size(); ++p) {
    add(backward, found[p][0], points[p].area);
    add(forward, found[p][1], points[p].area);
    add(net, found[p][0], -points[p].area);
    add(net, found[p][1], points[p].area);
  }
  reading.measurements = {forward, backward, net};
}

void SensorReader::read_point(const Sensor& sensor, const Locate& locate, StageCounter& counter,
                              SensorReading& reading) const {
  const PointInCell place = locate(sensor.position).value();
  Worker work{RayRadiance::Workspace(scene_), counter};
  if (sensor.kind == SensorKind::cone) return read_cone(place, sensor, work, reading);
  const auto add = [&](Quantity quantity, AtPoint here) {
    reading.measurements.push_back(
        {quantity, std::move(here.uncollided), std::move(here.collided), std::move(here.error)});
  };
  if (sensor.kind == SensorKind::radiance) {
    add(Quantity::radiance, radiance(place, sensor.direction, work));
    counter.add();
  } else if (sensor.kind == SensorKind::exitance || sensor.kind == SensorKind::radiosity) {
    add(sensor.kind == SensorKind::exitance ? Quantity::exitance : Quantity::radiosity,
        exitance(place, sensor.direction, sensor.rays, work));
  } else if (sensor.kind == SensorKind::fluence) {
    add(Quantity::fluence, fluence(place, sensor, work));
  } else {
    add(Quantity::irradiance, irradiance(place, sensor.direction, sensor.rays, work));
  }
}

std::optional<SensorReading> SensorReader::read(const Sensor& sensor, const Locate& locate, int threads,
                                                StageCounter& counter) const {
  SensorReading reading;
  if (sensor.kind == SensorKind::grid) {
    read_grid(sensor, locate, threads, counter, reading);
  } else if (sensor.kind == SensorKind::flux) {
    read_flux(sensor, locate, threads, counter, reading);
  } else if (sensor.kind == SensorKind::intensity) {
    reading.grid =
        wall_intensity(lights_, scene_, sensor.wall, sensor.count[0], sensor.count[1], threads, &counter);
    reading.measurements.push_back(most_of(reading.grid, scene_.bands(), Quantity::intensity_most));
  } else {
    read_point(sensor, locate, counter, reading);
    if (sensor.kind == SensorKind::glare)
      reading.view = observe_view(lights_, scene_, locate(sensor.position).value(), sensor, threads, counter);
  }
  if (counter.stopped()) return std::nullopt;
  return reading;
}

SensorReading SensorReader::read(const Sensor& sensor, const Locate& locate, int threads) const {
  StageCounter counter(rays_of(sensor, locate), {});
  return read(sensor, locate, threads, counter).value();
}

std::size_t SensorReader::rays_of(const Sensor& sensor, const Locate& locate) const {
  const std::size_t rays = counted_rays(sensor.rays);
  switch (sensor.kind) {
    case SensorKind::grid:
      return value_count(sensor) * rays;
    case SensorKind::flux:
      return flux_points(sensor, locate).size() * (sensor.half_angle > 0 ? rays : 2 * rays);
    case SensorKind::intensity:
      return intensity_rays(scene_.problem().mesh(), sensor.wall, value_count(sensor));
    case SensorKind::radiance:
      return 1;
    case SensorKind::glare:
      return rays + rays_of_view(sensor);
    default:
      return rays;
  }
}

}  // namespace etendue
