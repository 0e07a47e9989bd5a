// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/radiance/once_scattered.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "solver/angular/kernels/scattered_light.h"

namespace etendue {
namespace {

constexpr double per_sphere = 1 / (4 * std::numbers::pi);

}  // namespace

OnceScattered::Memory::Memory(const OnceScattered& scattered)
    : known(scattered.first_->collisions.empty() ? 0 : scattered.first_->collisions.directions().size(), 0),
      values(known.size() * scattered.ways()),
      matter(scattered.matter_.kind_count()) {}

OnceScattered::OnceScattered(const LightSetup& lights, std::shared_ptr<const FirstCollisions> first)
    : lights_(lights),
      problem_(lights.problem()),
      phases_(problem_),
      matter_(lights.paths().matter()),
      first_(std::move(first)) {
  if (lights.empty()) return;
  for (std::size_t kind = 0; kind < matter_.kind_count(); ++kind) {
    const auto* leaves = std::get_if<LeafCanopy>(&matter_.scattering(static_cast<int>(kind)));
    normals_.push_back(leaves != nullptr ? leaf_normals(leaves->angles) : LeafNormals{});
  }
  const CollisionField& collisions = first_->collisions;
  if (collisions.empty() || normals_.empty()) return;
  for (std::size_t i = 0; i < collisions.directions().size(); ++i)
    for (const PathCoefficients& kind : matter_.view(collisions.directions().direction(i)).kinds)
      unit_scattering_.push_back(kind.scattering);
}

int OnceScattered::way_of(int region, std::size_t band) const {
  if (const int kind = matter_.kind_of(region, band); kind >= 0)
    return static_cast<int>(phases_.phases().size()) + kind;
  return phases_.of(region, band);
}

void OnceScattered::ask_matter(const Vec3& beam, const Vec3& travel, Memory& memory) const {
  if (memory.beam == beam) return;
  memory.beam = beam;
  for (std::size_t kind = 0; kind < normals_.size(); ++kind)
    memory.matter[kind] =
        scattering_value(matter_.scattering(static_cast<int>(kind)), normals_[kind], beam, travel);
}

const double* OnceScattered::scattered_from(std::size_t direction, const Vec3& travel, Memory& memory) const {
  double* const values = &memory.values[direction * ways()];
  if (memory.known[direction] == memory.ray) return values;
  memory.known[direction] = memory.ray;
  const Vec3& incident = first_->collisions.directions().direction(direction);
  const std::size_t phases = phases_.phases().size();
  for (std::size_t p = 0; p < phases; ++p)
    values[p] = phase_value(phases_.phases()[p], std::clamp(travel.dot(incident), -1., 1.)) - per_sphere;
  if (normals_.empty()) return values;
  ask_matter(incident, travel, memory);
  for (std::size_t kind = 0; kind < normals_.size(); ++kind) {
    const double all = unit_scattering_[direction * normals_.size() + kind];
    values[phases + kind] = all > 0 ? memory.matter[kind] / all - per_sphere : 0;
  }
  return values;
}

void OnceScattered::add_at_vertices(CellIndex cell, const Vec3& travel, Memory& memory,
                                    std::span<double> values) const {
  if (first_->scattered.empty()) return;
  const std::size_t bands = lights_.paths().bands();
  for (std::size_t i = 0; i < 4 * bands; ++i)
    values[i] += per_sphere * first_->scattered[cell.at() * 4 * bands + i];
  if (first_->collisions.empty()) return;
  const int region = problem_.mesh().region(cell);
  const std::span<const std::int32_t> incident = first_->collisions.directions_at(cell);
  for (std::size_t k = 0; k < incident.size(); ++k) {
    const double* shares = scattered_from(static_cast<std::size_t>(incident[k]), travel, memory);
    const std::span<const double> power = first_->collisions.values(cell, k);
    for (std::size_t b = 0; b < bands; ++b)
      if (const int way = way_of(region, b); way >= 0)
        for (std::size_t i = 0; i < 4; ++i) values[i * bands + b] += shares[way] * power[i * bands + b];
  }
}

void OnceScattered::add_at(const PointInCell& point, const Vec3& travel, LightBeams& beams,
                           std::span<double> values) const {
  const int region = problem_.mesh().region(point.cell);
  beams.clear();
  for (const auto& source : lights_.sources())
    source->add_beams(point, Sight::attenuated, shaft_light, beams);
  const std::size_t phases = phases_.phases().size();
  std::vector<double> turned(ways());
  std::optional<Memory> memory;
  for (std::size_t i = 0; i < beams.size(); ++i) {
    const Vec3& beam = beams.direction(i);
    const double cosine = std::clamp(travel.dot(beam), -1., 1.);
    for (std::size_t p = 0; p < phases; ++p) turned[p] = phase_value(phases_.phases()[p], cosine);
    RayMatter::View view;
    if (matter_.depends_on_direction(region)) {
      if (!memory) memory.emplace(*this);
      view = matter_.view(beam);
      ask_matter(beam, travel, *memory);
      for (std::size_t kind = 0; kind < view.kinds.size(); ++kind)
        turned[phases + kind] =
            view.kinds[kind].scattering > 0 ? memory->matter[kind] / view.kinds[kind].scattering : 0;
    }
    for (std::size_t b = 0; b < beams.bands(); ++b) {
      const int way = way_of(region, b);
      values[b] += matter_.at(point.cell, b, view, point.position).scattering * beams.fluence(i)[b] *
                   (way < 0 ? per_sphere : turned[static_cast<std::size_t>(way)]);
    }
  }
}

}  // namespace etendue
