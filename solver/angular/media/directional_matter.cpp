// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/angular/media/directional_matter.h"

#include <algorithm>
#include <numeric>

#include "solver/angular/kernels/scattered_light.h"
#include "solver/materials/kernels/leaf_canopy.h"
#include "solver/materials/kernels/micro_flakes.h"

namespace etendue {
bool is_seen_by_rays(const DirectionalScattering& scattering) {
  return std::holds_alternative<LeafCanopy>(scattering) || std::holds_alternative<MicroFlakes>(scattering);
}

DirectionalMatter::DirectionalMatter(const Problem& problem, const DirectionSet& directions)
    : problem_(problem), directions_(directions), bands_(static_cast<std::size_t>(problem.band_count())) {
  for (const Medium& medium : problem.media())
    for (std::size_t b = 0; b < bands_; ++b) {
      if (b >= medium.directional.size() || !is_seen_by_rays(medium.directional[b])) {
        number_.push_back(-1);
        continue;
      }
      const DirectionalScattering& scattering = medium.directional[b];
      auto same = std::ranges::find(kinds_, scattering, &Kind::scattering);
      if (same == kinds_.end()) {
        Kind kind{scattering, {}, mean_leaf_projection};
        if (const auto* leaves = std::get_if<LeafCanopy>(&scattering))
          kind.normals = leaf_normals(leaves->angles);
        else
          kind.mean_extinction = mean_flake_projection(std::get<MicroFlakes>(scattering));
        same = kinds_.insert(kinds_.end(), std::move(kind));
      }
      number_.push_back(static_cast<int>(same - kinds_.begin()));
    }
}

std::vector<DirectionalMatter::View> DirectionalMatter::views(const Vec3& travel) const {
  std::vector<View> views;
  for (const Kind& kind : kinds_) {
    View view;
    if (const auto* leaves = std::get_if<LeafCanopy>(&kind.scattering)) {
      view.extinction = leaf_projection(leaves->angles, travel);
      view.scattered = view.extinction * (leaves->reflectance + leaves->transmittance);
    } else {
      const auto& flakes = std::get<MicroFlakes>(kind.scattering);
      view.extinction = flake_projection(flakes, travel);
      view.scattered = view.extinction * flakes.albedo;
    }
    for (std::size_t n = 0; n < directions_.directions().size(); ++n)
      view.weights.push_back(directions_.weights()[n] * scattering_value(kind.scattering, kind.normals,
                                                                         directions_.directions()[n],
                                                                         travel));
    const double sum = std::accumulate(view.weights.begin(), view.weights.end(), 0.0);
    for (double& weight : view.weights) weight = sum > 0 ? weight / sum : 0;
    views.push_back(std::move(view));
  }
  return views;
}

// The coefficients of the medium are means over directions.
double DirectionalMatter::density(CellIndex cell, std::size_t band) const {
  const auto b = static_cast<int>(band);
  const Kind& kind = kinds_[static_cast<std::size_t>(of(problem_.mesh().region(cell), band))];
  return (problem_.absorption(cell, b) + problem_.scattering(cell, b)) / kind.mean_extinction;
}

}  // namespace etendue
