// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <ostream>
#include <vector>

#include "app/case/case.h"
#include "app/render/error_images.h"
#include "app/request/command_line.h"
#include "app/write/image/pictures.h"
#include "solver/observe/radiance/ray_radiance.h"

namespace etendue {

/// Throws InputError with each camera and sensor where rays do not see the problem in this version.
void check_views(const std::vector<CameraCase>& cameras, const std::vector<SensorCase>& sensors,
                 const Problem& problem);

using TakePicture = std::function<Picture(const Camera& camera, const StageObserver& observer)>;
/// Adds what a picture is off by; false where it was interrupted.
using AddErrors = std::function<bool(NamedPicture& picture)>;

/// What is needed beside a scene to take pictures and to write them.
struct PictureOrder {
  const Case& input;
  const std::vector<CameraCase>& cameras;
  const std::filesystem::path& directory;
  ProgressStyle progress = ProgressStyle::none;
  std::ostream& out;
  const std::function<bool()>& interrupted;
  /// When the pictures of a run began: its summary counts them; empty for pictures of saved results.
  std::optional<std::chrono::steady_clock::time_point> begun = {};
};

/// Takes the cameras' pictures, whatever they see, and writes them into a directory, with progress. False
/// where `interrupted` said so: then no picture was written.
bool write_pictures(const PictureOrder& order, const TakePicture& take, const AddErrors& add_errors);

/// Takes the cameras' pictures and writes them into a directory, with progress. False where `interrupted`
/// said so: then no picture was written.
bool write_pictures(const Case& input, const std::vector<CameraCase>& cameras, const RayRadiance& scene,
                    const ErrorImages& errors, int threads, const std::filesystem::path& directory,
                    ProgressStyle progress, std::ostream& out, const std::function<bool()>& interrupted,
                    std::optional<std::chrono::steady_clock::time_point> begun = {});

}  // namespace etendue
