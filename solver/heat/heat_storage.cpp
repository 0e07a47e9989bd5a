// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/heat/heat_storage.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/errors.h"
#include "base/quadrature/gauss_legendre.h"
#include "mesh/tetrahedra/corners.h"

namespace etendue {
namespace {

constexpr int temperature_points = 5;

}  // namespace

HeatStorage::HeatStorage(const Problem& problem, const HeatProblem& heat, const TemperatureSpace& space)
    : heat_(heat), size_(space.size()) {
  if (!heat.changes_in_time) return;
  const TetrahedralMesh& mesh = problem.mesh();
  std::map<std::pair<std::size_t, std::int32_t>, Place> of_media;  // [unknown, region]
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    const auto& medium = heat.media[static_cast<std::size_t>(mesh.region(cell))];
    for (std::size_t i = 0; i < 4 && space.has(cell); ++i) {
      const auto unknown = static_cast<std::size_t>(space.unknown(cell, i));
      const Place none{unknown, &medium->in_time, &medium->origin, 0, corner_of(mesh, cell, i)};
      of_media.try_emplace({unknown, mesh.region(cell)}, none).first->second.size += mesh.volume(cell) / 4;
    }
  }
  for (const auto& [key, place] : of_media) places_.push_back(place);
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    if (!space.has(face)) continue;
    const HeatWall& wall = *heat.walls[static_cast<std::size_t>(mesh.wall(face))];
    for (std::size_t i = 0; i < 3; ++i)
      places_.push_back({static_cast<std::size_t>(space.unknown(face, i)), &wall.in_time, &wall.origin,
                         mesh.area(face) / 3, corner_of(mesh, face, i)});
  }
  capacity(start());  // faults are found before the first step
}

double HeatStorage::capacity_at(const Place& place, double kelvin) const {
  const double capacity = place.in_time->capacity.at(place.point, std::abs(kelvin));
  if (std::isfinite(capacity) && capacity >= 0) return capacity;
  throw InputError(
      fault_at(*place.origin, "heat_capacity",
               fmt::format("is {:g} at ({:.6g}, {:.6g}, {:.6g}) and {:.6g} K; use at least 0", capacity,
                           place.point.x(), place.point.y(), place.point.z(), std::abs(kelvin))));
}

std::vector<double> HeatStorage::capacity(std::span<const double> temperature) const {
  std::vector<double> result(size_, 0);
  for (const Place& place : places_)
    result[place.unknown] += place.size * capacity_at(place, temperature[place.unknown]);
  return result;
}

std::vector<double> HeatStorage::heat(std::span<const double> from, std::span<const double> to) const {
  static const GaussRule rule = gauss_legendre(temperature_points);
  std::vector<double> result(size_, 0);
  for (const Place& place : places_) {
    const double low = from[place.unknown], difference = to[place.unknown] - low;
    double mean = 0;
    if (place.in_time->capacity.depends_on_temperature())
      for (std::size_t k = 0; k < rule.nodes.size(); ++k)
        mean += rule.weights[k] / 2 * capacity_at(place, low + difference * (1 + rule.nodes[k]) / 2);
    else
      mean = capacity_at(place, low);
    result[place.unknown] += place.size * mean * difference;
  }
  return result;
}

/// Where media meet that conduct, the mean by volume.
std::vector<double> HeatStorage::start() const {
  std::vector<double> sums(size_, 0), sizes(size_, 0);
  for (const Place& place : places_) {
    const double kelvin = place.in_time->initial ? place.in_time->initial->at(place.point) : heat_.start;
    if (!(kelvin > 0) || !std::isfinite(kelvin))
      throw InputError(fault_at(*place.origin, "initial_temperature",
                                fmt::format("is {:g} at ({:.6g}, {:.6g}, {:.6g}); use more than 0", kelvin,
                                            place.point.x(), place.point.y(), place.point.z())));
    sums[place.unknown] += place.size * kelvin;
    sizes[place.unknown] += place.size;
  }
  for (std::size_t i = 0; i < size_; ++i) sums[i] = sizes[i] > 0 ? sums[i] / sizes[i] : heat_.start;
  return sums;
}

}  // namespace etendue
