// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "app/case/case.h"
#include "solver/observe/radiance/ray_radiance.h"

namespace etendue {

/// Sources of the images of estimated errors, for the cameras that ask for these: radiances of the solution
/// changed by its estimated errors. Their difference from the picture is the error of each pixel.
class ErrorImages {
 public:
  /// `direction_error` is that of the solution, empty where it is not known; `first` as in RayRadiance. The
  /// arguments must outlive it.
  ErrorImages(const std::vector<CameraCase>& cameras, const LightSetup& lights,
              const DirectionSet& directions, const SolveOptions& options, const SavedState& state,
              std::span<const double> direction_error,
              const std::shared_ptr<const FirstCollisions>& first = nullptr);
  ErrorImages(const ErrorImages&) = delete;
  ErrorImages& operator=(const ErrorImages&) = delete;

  /// With quadratics for the fluence and moments of each cell (quadratic_reconstruction), and what walls
  /// receive as the solution has it in each face, not joined. Null where no camera asks, with constant
  /// elements, and beside scattering by a matrix, whose radiance has no reconstruction.
  const RayRadiance* of_cells() const { return cells_ ? &*cells_ : nullptr; }
  /// With the standard error of rotated sets added to the fluence. Null where no camera asks or it is not
  /// known.
  const RayRadiance* of_directions() const { return directions_ ? &*directions_ : nullptr; }

 private:
  SavedState reconstructed_;
  SavedState brighter_;
  std::optional<RayRadiance> cells_;
  std::optional<RayRadiance> directions_;
};

}  // namespace etendue
