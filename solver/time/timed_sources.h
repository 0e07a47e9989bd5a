// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "solver/angular/sets/direction_set.h"
#include "solver/problem/problem.h"
#include "solver/time/emission_course.h"
#include "solver/transport/source/directional_emission.h"
#include "solver/transport/source/ordinate_lights.h"

namespace etendue {

/// The same problem without any emission, but for what Problem::set_following() says of media and of those
/// walls that emit.
Problem darkened(const Problem& problem);

/// Whether a wall sends anything in.
bool emits(const Wall& wall);

/// What a problem emits in the course of time. Light is left to the directions.
class TimedSources {
 public:
  /// The directions and the mesh must outlive it. Throws std::invalid_argument where there is not a course
  /// for each source, or where a pulse enters through a wall: it would last as long as a step.
  TimedSources(const Problem& problem, const DirectionSet& directions, const EmissionCourses& courses);

  /// What media and walls emit alike in all directions at a time.
  FollowingSources isotropic_at(double t) const;
  /// Adds the rest to the source of a cell along ordinate m, `values` [4][band]; `factors` are factors_at().
  void add_source(std::span<const double> factors, OrdinateIndex m, CellIndex cell,
                  std::span<double> values) const;
  /// The same at the vertices of a boundary face, [3][band].
  void add_inflow(std::span<const double> factors, OrdinateIndex m, FaceIndex face,
                  std::span<double> values) const;
  /// [course]; 0 for pulses.
  std::vector<double> factors_at(double t) const;
  /// Adds all that pulses emit in a cell along ordinate m, per unit of time, to `values` [4][band].
  void add_pulses(OrdinateIndex m, CellIndex cell, std::span<double> values) const;
  bool has_pulses() const;
  /// [band] What is emitted within the domain at a time [power].
  std::vector<double> power_inside(double t) const;

 private:
  /// Those sources of one course that depend on the direction.
  struct Directional {
    std::unique_ptr<Problem> problem;  ///< with these alone
    std::unique_ptr<OrdinateLights> lights;
    std::unique_ptr<DirectionalEmission> emission;
  };
  void check(const EmissionCourses& courses) const;
  /// Adds what `add` says of the sources of each course, times its factor.
  template <class Add>
  void add_scaled(std::span<const double> factors, std::span<double> values, const Add& add) const;
  void add_directional(std::size_t course, const DirectionSet& directions);
  void add_power(std::size_t course);

  const Problem problem_;
  EmissionCourses courses_;
  std::vector<Directional> directional_;    ///< [course]; with nothing in it where there is none
  std::vector<std::vector<double>> power_;  ///< [course][band] within the domain
};

}  // namespace etendue
