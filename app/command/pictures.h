// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <vector>

#include "app/case/case.h"
#include "app/command/command_line.h"
#include "app/command/error_scenes.h"
#include "app/write/pictures.h"
#include "solver/picture/ray_radiance.h"

namespace etendue {

/// Throws InputError with each camera and sensor where rays do not see the problem in this version.
void check_views(const std::vector<CameraCase>& cameras, const std::vector<SensorCase>& sensors,
                 const Problem& problem);

/// Takes the cameras' pictures and writes them into a directory, with progress. False where `interrupted`
/// said so: then no picture was written.
bool write_pictures(const Case& input, const std::vector<CameraCase>& cameras, const RayRadiance& scene,
                    const ErrorScenes& errors, int threads, const std::filesystem::path& directory,
                    ProgressStyle progress, std::ostream& out, const std::function<bool()>& interrupted);

}  // namespace etendue
