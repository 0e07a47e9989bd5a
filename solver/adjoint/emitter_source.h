// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "base/parallel/stage_observer.h"
#include "solver/adjoint/emitter.h"
#include "solver/adjoint/response.h"
#include "solver/transport/source/directional_emission.h"
#include "solver/transport/source/ordinate_lights.h"
#include "solver/uncollided/first_collision/first_collision.h"
#include "solver/uncollided/lights/light_setup.h"

namespace etendue {

/// All that the sweeps of a problem take as a source and an inflow on a set of directions: its emission, the
/// radiance of its walls, lights that are left to the directions, and first collisions.
class SweptSource : public AngularInput {
 public:
  /// `remaining` is LightSetup::remaining(). The arguments must outlive it.
  SweptSource(const LightSetup& lights, const UncollidedField& field, const Problem& remaining,
              const DirectionSet& directions, int threads);

  bool depends_on_direction(CellIndex cell) const override { return last_->depends_on_direction(cell); }
  void add_source(OrdinateIndex m, CellIndex cell, std::span<double> values) const override;
  void add_projected_source(OrdinateIndex m, CellIndex cell, std::span<double> values) const override {
    last_->add_projected_source(m, cell, values);
  }
  void add_inflow(OrdinateIndex m, FaceIndex face, std::span<double> values) const override;

 private:
  /// What a radiance of 1 of a wall that refracts sends in along the ordinates, by its plane.
  struct Entering {
    Vec3 normal;
    int wall;
    std::vector<double> factor;  ///< [ordinate]
  };
  void list_entering(const DirectionSet& directions);
  /// 1 where a wall does not refract.
  double entering(OrdinateIndex m, FaceIndex face) const;

  const Problem& remaining_;
  std::optional<FirstCollision> first_;  ///< empty without lights along rays
  OrdinateLights lights_;
  DirectionalEmission emission_;  ///< and all before it
  const AngularInput* last_;
  std::vector<Entering> entering_;
  std::vector<std::int32_t> plane_;  ///< [boundary face] place in `entering_`, -1: none
};

/// One emitter with its light along rays.
class EmitterSource {
 public:
  EmitterSource(Emitter emitter, int threads, const StageObserver& observer);
  EmitterSource(const EmitterSource&) = delete;
  EmitterSource& operator=(const EmitterSource&) = delete;

  const Emitter& emitter() const { return emitter_; }
  /// What it brings of a response before the first collision, [band].
  std::vector<double> uncollided(const Response& response) const;
  /// On a set of directions; this must outlive it.
  std::unique_ptr<const SweptSource> on(const DirectionSet& directions) const;

 private:
  Emitter emitter_;
  int threads_;
  LightSetup lights_;
  UncollidedField field_;
  Problem remaining_;
};

}  // namespace etendue
