// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "base/parallel/stage_observer.h"
#include "solver/observe/camera/camera.h"
#include "solver/observe/radiance/ray_radiance.h"

namespace etendue {

/// The radiance that a camera sees, [row from the top][column][band] [power/(length^2 sr)].
struct Picture {
  std::array<int, 2> pixels{};  ///< across, down
  std::size_t bands = 0;
  std::vector<double> radiance;
  bool whole = true;  ///< not so where it was stopped

  std::span<const double> pixel(int column, int row) const {
    const auto at = static_cast<std::size_t>(row) * static_cast<std::size_t>(pixels[0]) +
                    static_cast<std::size_t>(column);
    return std::span(radiance).subspan(at * bands, bands);
  }
};

/// Writes the radiance [band] that a camera sees along a ray; each thread has one of its own.
using RayLook = std::function<void(const CameraRay& ray, std::span<double> radiance)>;

/// Takes a picture of whatever the makers of looks see: the mean over a grid of rays in each pixel. The same
/// bits for any number of threads.
Picture take_picture(std::size_t bands, const std::function<RayLook()>& make_look, const Camera& camera,
                     int threads, const StageObserver& observer);

/// Takes a picture: the mean of the radiance over a grid of rays in each pixel. What no ray meets is dark.
/// The same bits for any number of threads. `gathering` is called while the light of walls is looked for,
/// before the first pixel, where the camera asks for that.
Picture take_picture(const RayRadiance& radiance, const Camera& camera, int threads,
                     const StageObserver& observer = {}, const StageObserver& gathering = {});

}  // namespace etendue
