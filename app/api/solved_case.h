// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "app/case/case.h"
#include "app/run/ordinates_setup.h"
#include "app/write/result/run_result.h"
#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/observe/radiance/ray_radiance.h"
#include "solver/uncollided/lights/light_setup.h"

namespace etendue::v0 {

/// What rays see of a solution by radiosity: its lights, and the directions that its walls are sampled in.
struct RadiosityViews {
  RadiosityViews(const Problem& problem, DirectionSet sampled, SolveOptions solving)
      : lights(problem), directions(std::move(sampled)), options(std::move(solving)) {}

  LightSetup lights;
  DirectionSet directions;
  SolveOptions options;
};

/// A case on a mesh with all that is known of its solution. Its parts refer to each other: it stays where it
/// is.
struct SolvedCase {
  SolvedCase(etendue::Case given, std::shared_ptr<const TetrahedralMesh> on);
  SolvedCase(const SolvedCase&) = delete;
  SolvedCase& operator=(const SolvedCase&) = delete;

  int threads() const;
  const LightSetup* lights() const;  ///< null of photons

  etendue::Case input;  ///< of which the folder of results alone may change
  const std::shared_ptr<const TetrahedralMesh> mesh;
  Problem problem;  ///< changes where temperatures follow
  const CellLocator locator;
  std::unique_ptr<OrdinatesSetup> ordinates;  ///< of a solution by ordinates
  std::unique_ptr<RadiosityViews> radiosity;  ///< of a solution by radiosity
  etendue::Solution solution;
  std::shared_ptr<const FirstCollisions> first_collisions;  ///< of ordinates
  std::optional<RayRadiance> rays;    ///< what sensors and cameras look at; made where it is needed first
  std::optional<TimeResult> in_time;  ///< of temperatures that change with time
  std::optional<RunResult> result;
};

/// Functions of the caller that a solve calls.
struct SolveHooks {
  std::function<void(const std::string& stage)> begins;
  std::function<bool(const SweepProgress& progress)> swept;  ///< false: the solution so far is enough
  std::function<bool()> stop;
};

/// Throws Stopped where a stage was ended by SolveHooks::stop.
void throw_if_stopped(const SolveHooks& hooks);

// Solve by the method of the case and read its probes and sensors. They throw as the command's runs do, and
// Stopped.
void solve_by_ordinates(SolvedCase& solved, const SolveHooks& hooks);
void solve_by_photons(SolvedCase& solved, const SolveHooks& hooks);
void solve_by_radiosity(SolvedCase& solved, const SolveHooks& hooks);

/// What rays see of a solution by ordinates or radiosity; made at the first call.
const RayRadiance& rays_of(SolvedCase& solved);

/// The result of a solution, with its balances and totals.
RunResult measured(const SolvedCase& solved);

}  // namespace etendue::v0
