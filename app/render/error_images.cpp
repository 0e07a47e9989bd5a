// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/render/error_images.h"

#include <algorithm>

#include "solver/observe/radiance/quadratic_reconstruction.h"

namespace etendue {

ErrorImages::ErrorImages(const std::vector<CameraCase>& cameras, const LightSetup& lights,
                         const DirectionSet& directions, const SolveOptions& options, const SavedState& state,
                         std::span<const double> direction_error,
                         const std::shared_ptr<const FirstCollisions>& first) {
  if (std::ranges::none_of(cameras, [](const CameraCase& camera) { return camera.camera.errors; })) return;
  if (options.order == SpaceOrder::linear && state.radiance.empty()) {
    const CollidedSource source(lights, directions, options, state);
    reconstructed_ = quadratic_reconstruction(lights.problem(), state, source.rows(), options.threads);
    cells_.emplace(lights, directions, options, reconstructed_, options.threads, WallValues::raw, first);
  }
  if (direction_error.empty()) return;
  brighter_ = state;
  const std::size_t bands = lights.paths().bands();
  const std::size_t cell = brighter_.fluence.size() / (direction_error.size() / bands);  // values of each
  for (std::size_t i = 0; i < brighter_.fluence.size(); ++i)
    brighter_.fluence[i] += direction_error[i / cell * bands + i % bands];
  directions_.emplace(lights, directions, options, brighter_, options.threads, WallValues::joined, first);
}

}  // namespace etendue
