// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "solver/angular/sets/direction_set.h"
#include "solver/problem/problem.h"
#include "solver/solution/angular_input.h"
#include "solver/solution/solution.h"
#include "solver/time/laplace_problem.h"
#include "solver/time/timed_sources.h"

namespace etendue {

/// The numbers of all ordinates of a set.
std::vector<int> all_ordinates(const DirectionSet& directions);

/// What a step adds to the source along each direction: the radiance that was, times n / (c stage), sources
/// that depend on the direction, and the first collisions of light along rays.
class AngularHistory : public AngularInput {
 public:
  /// The arguments must outlive it; `collisions` is null where all is left to the directions.
  AngularHistory(const Problem& problem, const TimedSources& sources, const Slowness& slowness,
                 const AngularInput* collisions = nullptr)
      : bands_(static_cast<std::size_t>(problem.band_count())),
        mesh_(problem.mesh()),
        sources_(sources),
        slowness_(slowness),
        collisions_(collisions) {}

  /// Sets the radiance at t = 0: c/n times what pulses emit. Returns its fluence [cell][4][band].
  std::vector<double> begin(const DirectionSet& directions);
  /// The radiance that was is `of_last` times that of the last step and `of_other` times that of the stage,
  /// or of the step before.
  void mix(double of_last, double of_other) {
    of_last_ = of_last;
    of_other_ = of_other;
  }
  void set_time(double stage, double t) {
    stage_ = stage;
    factors_ = sources_.factors_at(t);
  }
  /// All ordinates in their order, as a solution has them.
  void keep_stage(std::vector<OrdinateRadiance> radiance) { other_ = std::move(radiance); }
  /// The radiance at the end of a step; that of its beginning is kept for the step after it, or given up.
  void accept(std::vector<OrdinateRadiance> radiance, bool keeps_before);

  void add_source(OrdinateIndex m, CellIndex cell, std::span<double> values) const override;
  void add_projected_source(OrdinateIndex m, CellIndex cell, std::span<double> values) const override {
    if (collisions_ != nullptr) collisions_->add_projected_source(m, cell, values);
  }
  void add_inflow(OrdinateIndex m, FaceIndex face, std::span<double> values) const override {
    sources_.add_inflow(factors_, m, face, values);
    if (collisions_ != nullptr) collisions_->add_inflow(m, face, values);
  }

 private:
  std::size_t bands_;
  const TetrahedralMesh& mesh_;
  const TimedSources& sources_;
  const Slowness& slowness_;
  const AngularInput* collisions_;
  std::vector<OrdinateRadiance> last_;  ///< values [cell][4][band]; empty: darkness
  std::vector<OrdinateRadiance> other_;
  double of_last_ = 1, of_other_ = 0;
  double stage_ = 1;  ///< [time]
  std::vector<double> factors_;
};

}  // namespace etendue
