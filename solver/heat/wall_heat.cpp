// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/heat/wall_heat.h"

#include <algorithm>
#include <numbers>

#include "base/field_view.h"

namespace etendue {

namespace {

using std::numbers::pi;

/// At the vertices of a face: as linear elements have it, with the same mean, but nowhere below zero, as it
/// may be at the edge of a beam.
std::array<double, 3> positive_irradiance(const ConstFaceField& irradiance, FaceIndex face,
                                          std::size_t band) {
  const double mean = irradiance.mean(face, band);
  std::array<double, 3> values = {irradiance(face, 0, band), irradiance(face, 1, band),
                                  irradiance(face, 2, band)};
  const double least = std::ranges::min(values);
  if (least >= 0) return values;
  const double part = mean > 0 ? mean / (mean - least) : 0;
  for (double& value : values) value = mean + part * (value - mean);
  return values;
}

}  // namespace

WallHeat::WallHeat(const Problem& problem, const HeatProblem& heat, const TemperatureSpace& space)
    : problem_(problem), heat_(heat), factors_(heat.walls.size(), 1) {
  const TetrahedralMesh& mesh = problem.mesh();
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    if (!space.has(face)) continue;
    FollowingFace following{face, static_cast<std::size_t>(mesh.wall(face)), {}};
    for (std::size_t i = 0; i < 3; ++i)
      following.unknowns[i] = static_cast<std::size_t>(space.unknown(face, i));
    faces_.push_back(following);
  }
}

void WallHeat::set_time(double t) {
  for (std::size_t wall = 0; wall < factors_.size(); ++wall)
    if (const auto& heated = heat_.walls[wall]; heated && heated->in_time.factor)
      factors_[wall] = heated->in_time.factor(t);
}

std::vector<double> WallHeat::radiance(const Blackbodies& blackbodies) const {
  if (faces_.empty()) return {};
  const auto bands = static_cast<std::size_t>(problem_.band_count());
  std::vector<double> result(static_cast<std::size_t>(problem_.mesh().boundary_face_count()) * 3 * bands, 0);
  const FaceField radiance(result, bands);
  for (const FollowingFace& face : faces_)
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t band = 0; band < bands; ++band)
        radiance(face.face, i, band) =
            emissivity(face, band) * blackbodies.radiance[face.unknowns[i] * bands + band];
  return result;
}

void WallHeat::add_gains(std::span<const double> temperature, const Blackbodies& blackbodies,
                         const LightAtVertices& light, std::vector<double>& gains) const {
  const auto bands = static_cast<std::size_t>(problem_.band_count());
  const ConstFaceField irradiance(light.irradiance, bands);
  for (const FollowingFace& face : faces_) {
    const HeatWall& wall = *heat_.walls[face.wall];
    std::array<double, 3> absorbed = {};
    for (std::size_t band = 0; band < bands; ++band) {
      const std::array<double, 3> arriving = positive_irradiance(irradiance, face.face, band);
      for (std::size_t i = 0; i < 3; ++i) absorbed[i] += emissivity(face, band) * arriving[i];
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t unknown = face.unknowns[i];
      double flux = absorbed[i] + factors_[face.wall] * wall.heat_flux +
                    wall.heat_transfer_coefficient * (wall.ambient - temperature[unknown]);
      for (std::size_t band = 0; band < bands; ++band)
        flux -= emissivity(face, band) * light.half_range[face.face.at()] *
                blackbodies.radiance[unknown * bands + band];
      gains[unknown] += problem_.mesh().area(face.face) / 3 * flux;
    }
  }
}

double WallHeat::emission_slope(const FollowingFace& face, std::size_t i,
                                const Blackbodies& blackbodies) const {
  const auto bands = static_cast<std::size_t>(problem_.band_count());
  double slope = 0;
  for (std::size_t band = 0; band < bands; ++band)
    slope += pi * emissivity(face, band) * blackbodies.slope[face.unknowns[i] * bands + band];
  return slope;
}

std::vector<double> WallHeat::convected(std::span<const double> temperature) const {
  std::vector<double> heat(heat_.walls.size(), 0);
  for (const FollowingFace& face : faces_)
    for (const std::size_t unknown : face.unknowns)
      heat[face.wall] += problem_.mesh().area(face.face) / 3 * convection_slope(face) *
                         (temperature[unknown] - heat_.walls[face.wall]->ambient);
  return heat;
}

}  // namespace etendue
