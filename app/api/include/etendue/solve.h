// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <string>

#include <etendue/case.h>
#include <etendue/solution.h>

namespace etendue {
ETENDUE_INTERFACE_BEGIN
/// How far a solve is.
struct Progress {
  std::string stage = {};                 ///< "sweeps", or the name of what begins: "meshing", "probes", …
  int sweep = 0;                          ///< of sweeps, from 1; else 0
  std::span<const double> residual = {};  ///< [band] of sweeps: estimated relative error of the iteration
  double tolerance = 0;                   ///< of sweeps
  double seconds = 0;                     ///< of sweeps, since the first began
  double seconds_left = -1;               ///< of sweeps, estimated; negative: unknown
};

struct SolveSettings {
  int threads = 0;  ///< 0: as the case says
  /// Called by the calling thread where a stage begins and after every sweep. False ends the iteration: the
  /// solution is then that of the last sweep, and has not converged. Exceptions end the solve.
  std::function<bool(const Progress&)> progress = {};
  /// Asked often, by all threads at once: true ends the solve within a sweep, which throws Stopped. Meshing
  /// and light before its first collision are completed first.
  std::function<bool()> stop = {};
};

/// Meshes and solves a case. Not converging is a result, marked in the solution. Several threads may solve
/// at once. Throws InputError, FileError, NotFiniteError and Stopped.
ETENDUE_EXPORT Solution solve(const Case& input, const SolveSettings& settings = {});
/// Solves a case on a mesh that was made before, by Case::mesh() of this case or of one with the same
/// geometry.
ETENDUE_EXPORT Solution solve(const Case& input, const Mesh& mesh, const SolveSettings& settings = {});

/// Finds what a run refuses before its first sweep, on this mesh. Throws InputError.
ETENDUE_EXPORT void check(const Case& input, const Mesh& mesh);

ETENDUE_INTERFACE_END
}  // namespace etendue
