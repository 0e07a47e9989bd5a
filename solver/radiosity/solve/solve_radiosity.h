// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "solver/problem/problem.h"
#include "solver/radiosity/exchange/exchange_links.h"
#include "solver/radiosity/exchange/exchange_matrix.h"
#include "solver/radiosity/exchange/factor_checks.h"
#include "solver/radiosity/patches/patch_refinement.h"
#include "solver/radiosity/patches/wall_patches.h"
#include "solver/radiosity/solve/patch_light.h"
#include "solver/radiosity/solve/radiosity_equation.h"
#include "solver/radiosity/solve/radiosity_method.h"
#include "solver/radiosity/solve/wall_light_field.h"
#include "solver/solution/saved_state.h"
#include "solver/solution/solution.h"

namespace etendue {

struct RadiosityOptions {
  double patch_size = 0;  ///< [length]; 0: each boundary face is a patch
  RefinementRule refinement;
  RadiosityMethod method = RadiosityMethod::gathering;
  int rays = 16;                 ///< between two patches, and eight times as many where some are blocked
  double link_tolerance = 3e-4;  ///< of hierarchical: see LinkRule
  int path_rays = 1024;          ///< from each patch, where mirrors or glossy walls redirect light
  RadiosityLimits limits;
  int threads = 1;
  std::size_t largest_kept = largest_kept_matrix;  ///< bytes of a matrix
};

/// How far the form factors are.
struct RadiosityStage {
  std::size_t round = 0;  ///< how often patches were cut
  std::size_t patches = 0;
  double done = 0;  ///< of the factors of these patches, 0 to 1
};
/// Looks at stages; the first of each round comes before anything is made.
using RadiosityWatcher = std::function<void(const RadiosityStage&)>;

/// What a solution by radiosity has beside the fields.
struct RadiosityReport {
  std::vector<std::size_t> rounds;  ///< patches of each round of refinement, the last: of the solution
  std::size_t patches = 0;
  double smallest_area = 0, largest_area = 0;  ///< of a patch [length^2]
  bool convex = false;                         ///< nothing can be between patches
  bool kept = true;                            ///< the matrix, and not made anew in each pass
  std::size_t links = 0;                       ///< of a hierarchical solution, which has no matrix
  std::vector<std::size_t> link_rounds;        ///< links of each round of their refinement
  FactorChecks checks;
  std::size_t extended_entries = 0;  ///< pairs of patches that mirrors and glossy walls connect
  ExtendedClosing extended_closing;  ///< where there are any
  std::vector<double> wall_factors;  ///< [wall][wall] see factors_of_walls()
  std::vector<Bounce> bounces;
  int passes = 0;
  double factor_seconds = 0, solve_seconds = 0, field_seconds = 0;
};

/// Walls that exchange light through a domain with a non-participating medium: patches, their factors and
/// what they send.
class RadiosityRoom {
 public:
  /// The problem must outlive it. Throws InputError where it asks for what radiosity does not know. Patches
  /// are solved for roughly and cut until none is to be cut; what the watcher throws comes through.
  RadiosityRoom(const Problem& problem, const RadiosityOptions& options,
                const RadiosityWatcher& watcher = {});

  RadiosityRoom(const RadiosityRoom&) = delete;
  RadiosityRoom& operator=(const RadiosityRoom&) = delete;

  const WallPatches& patches() const { return patches_; }
  const Exchange& exchange() const { return *exchange_; }
  const RadiosityReport& report() const { return report_; }

  /// Solves; the observer gets states of the iteration, to be made fields of by fields_on_walls(). Then the
  /// field in the cells is found.
  Solution solve(const RadiosityObserver& observer = {}, const FactorProgress& of_cells = {});
  /// The state that was solved last.
  const RadiosityState& solved() const { return solved_; }
  const std::vector<double>& irradiance() const { return solved_.irradiance; }
  /// Irradiance and exitance of the boundary faces.
  void fields_on_walls(const RadiosityState& state, Solution& fields) const;
  /// The field at points, of the state that was solved last; `rays` look at each patch from a point, and
  /// `path_rays` around where light is redirected.
  WallLightField light(int rays, int path_rays) const;
  /// The state that was solved last as rays of pictures and sensors look at it: what walls receive, but for
  /// what comes straight from the walls that are `followed` [wall] along rays as lights. Nothing scatters, so
  /// the fluence is none. It is divided by `half_range` [boundary face] to be reflected.
  SavedState state(const std::vector<bool>& followed, std::span<const double> half_range) const;

 private:
  /// [patch] what it sends out, of the mean irradiance, in the band where that is most: as if what is
  /// reflected came evenly to all walls, and of a rough solution.
  std::vector<double> likely_brightness() const;
  std::vector<double> solved_brightness() const;
  void make_factors(const RadiosityWatcher& watcher);
  void make_links(const FactorProgress& progress);
  void make_matrix(const FactorProgress& progress);
  void extend();
  void close();
  RadiosityEquation equation() const;
  RadiosityState solve(const RadiosityEquation& equation, const RadiosityObserver& observer) const;
  void fill_cells(Solution& fields, const FactorProgress& progress) const;
  std::vector<double> straight_irradiance(const RadiosityLimits& limits) const;
  std::vector<double> irradiance_by_rays(const std::vector<bool>& walls) const;

  const Problem& problem_;
  RadiosityOptions options_;
  std::size_t bands_;
  WallPatches patches_;
  std::unique_ptr<Exchange> exchange_;
  std::unique_ptr<ExtendedExchange> extended_;  ///< where walls redirect light
  RadiosityReport report_;
  RadiosityState solved_;
  std::vector<double> exitance_;  ///< [patch][band] of the solution, the diffuse part
};

/// Throws InputError that names all in a problem that radiosity does not know: media that scatter, absorb
/// or emits, lights, radiance that depends on the direction, directions of the plane.
void refuse_for_radiosity(const Problem& problem);

/// Bytes that a solution takes at most, and whether the matrix is kept.
struct RadiosityMemory {
  std::size_t patches = 0;
  bool kept = true;
  std::size_t links = 0;  ///< about so many, of a hierarchical solution
  std::size_t bytes = 0;
};
RadiosityMemory radiosity_memory(const Problem& problem, const RadiosityOptions& options,
                                 std::size_t patches);

}  // namespace etendue
