// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <vector>

#include "app/case/case.h"
#include "app/command/command_line.h"
#include "app/write/pictures.h"
#include "solver/lights/light_setup.h"

namespace etendue {

/// Throws InputError with each camera where pictures are not in this version.
void check_cameras(const std::vector<CameraCase>& cameras, const Problem& problem);

/// What pictures are taken of.
struct SavedScene {
  const LightSetup& lights;
  const DirectionSet& directions;
  const SolveOptions& options;  ///< of the solution: elements, meters; threads
  const SavedState& state;
};

/// Takes the cameras' pictures and writes them into a directory, with progress. False where `interrupted`
/// said so: then no picture was written.
bool write_pictures(const Case& input, const std::vector<CameraCase>& cameras, const SavedScene& scene,
                    const std::filesystem::path& directory, ProgressStyle progress, std::ostream& out,
                    const std::function<bool()>& interrupted);

}  // namespace etendue
