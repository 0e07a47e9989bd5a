// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/adjoint/emitter_source.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "solver/angular/refraction/ordinate_reflectance.h"
#include "solver/transport/walls/same_plane.h"

namespace etendue {
namespace {

UncollidedField field_of(const LightSetup& lights, int threads, const StageObserver& observer) {
  if (lights.empty()) return {};
  return uncollided_field(lights.paths(), lights.sources(), threads, observer);
}

}  // namespace

SweptSource::SweptSource(const LightSetup& lights, const UncollidedField& field, const Problem& remaining,
                         const DirectionSet& directions, int threads)
    : remaining_(remaining),
      first_(lights.empty()
                 ? std::nullopt
                 : std::optional<FirstCollision>(std::in_place, lights, field, directions, threads)),
      lights_(remaining, directions, first_ ? &*first_ : nullptr),
      emission_(remaining, directions, lights_.empty() && !first_ ? nullptr : &lights_),
      last_(&emission_) {
  list_entering(directions);
}

void SweptSource::list_entering(const DirectionSet& directions) {
  const TetrahedralMesh& mesh = remaining_.mesh();
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const int wall = mesh.wall(FaceIndex(f));
    plane_.push_back(-1);
    if (remaining_.wall(wall).refractive_index == 1) continue;
    const Vec3 normal = mesh.area_normal(FaceIndex(f)).normalized();
    auto found = std::ranges::find_if(entering_, [&](const Entering& plane) {
      return plane.wall == wall && (plane.normal - normal).norm() <= same_plane;
    });
    if (found == entering_.end()) {
      std::vector<double> factor = ordinate_reflectances(directions, remaining_.wall(wall), normal);
      for (double& value : factor) value = std::pow(remaining_.wall(wall).refractive_index, 2) * (1 - value);
      found = entering_.insert(found, {normal, wall, std::move(factor)});
    }
    plane_.back() = static_cast<std::int32_t>(found - entering_.begin());
  }
}

double SweptSource::entering(OrdinateIndex m, FaceIndex face) const {
  const std::int32_t plane = plane_[face.at()];
  return plane < 0 ? 1 : entering_[static_cast<std::size_t>(plane)].factor[m.at()];
}

void SweptSource::add_source(OrdinateIndex m, CellIndex cell, std::span<double> values) const {
  const auto bands = static_cast<std::size_t>(remaining_.band_count());
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t b = 0; b < bands; ++b)
      values[i * bands + b] += remaining_.cell_emission().at(cell, b, i);
  last_->add_source(m, cell, values);
}

void SweptSource::add_inflow(OrdinateIndex m, FaceIndex face, std::span<double> values) const {
  const auto bands = static_cast<std::size_t>(remaining_.band_count());
  const Wall& wall = remaining_.wall(remaining_.mesh().wall(face));
  const double factor = entering(m, face);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t b = 0; b < bands; ++b) values[i * bands + b] += factor * wall.radiance[b];
  last_->add_inflow(m, face, values);
}

EmitterSource::EmitterSource(Emitter emitter, int threads, const StageObserver& observer)
    : emitter_(std::move(emitter)),
      threads_(threads),
      lights_(emitter_.problem),
      field_(field_of(lights_, threads, observer)),
      remaining_(lights_.remaining()) {}

std::vector<double> EmitterSource::uncollided(const Response& response) const {
  if (lights_.empty()) return std::vector<double>(static_cast<std::size_t>(emitter_.problem.band_count()), 0);
  return uncollided_response(response, lights_, field_);
}

std::unique_ptr<const SweptSource> EmitterSource::on(const DirectionSet& directions) const {
  return std::make_unique<const SweptSource>(lights_, field_, remaining_, directions, threads_);
}

}  // namespace etendue
