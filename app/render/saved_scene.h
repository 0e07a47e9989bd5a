// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "app/case/case.h"
#include "app/write/vtk/solution_file.h"
#include "base/log.h"
#include "solver/angular/sets/direction_set.h"
#include "solver/problem/problem.h"
#include "solver/solution/solve_options.h"
#include "solver/uncollided/lights/light_setup.h"

namespace etendue {

/// The case of an earlier run with changes; empty where the directory holds none.
std::optional<Case> case_of_results(const std::filesystem::path& results, const Overrides& overrides);

/// A saved result, meshed again and ready to be looked into without solving.
class SavedScene {
 public:
  /// `input` is the case of the run, or one that differs in what is looked at alone. `command` is the one
  /// that asks, for messages. Throws InputError and FileError.
  SavedScene(Case input, const std::filesystem::path& results, const std::string& command,
             std::optional<int> threads, const Log& log);
  SavedScene(const SavedScene&) = delete;
  SavedScene& operator=(const SavedScene&) = delete;

  const Case input;
  const TetrahedralMesh mesh;
  const SavedResult result;
  const SavedState& state;  ///< that of the result
  const Problem problem;
  const DirectionSet directions;
  const LightSetup lights;
  const SolveOptions options;  ///< as the run had them: its probes decide in which cells moments were kept
};

}  // namespace etendue
